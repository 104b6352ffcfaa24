#include "render/live/shader_tree.h"

#include "gpu/shader_code.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <regex>

namespace lightbench {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargestSource = 4u << 20;

// Empty for what cannot be read: whoever includes it learns so from the compiler.
std::string text_of(const fs::path& file) {
    std::error_code error;
    const auto size = fs::file_size(file, error);
    if (error || size > kLargestSource) return "";
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool is_source(const fs::path& file) {
    static const std::set<std::string> known = {".glsl", ".vert", ".frag", ".comp", ".h"};
    return known.contains(file.extension().string());
}

std::set<std::string> includes_of(const std::string& text) {
    std::set<std::string> names;
    for (std::size_t at = text.find("#include \""); at != std::string::npos; at = text.find("#include \"", at)) {
        at += 10;
        const std::size_t end = text.find_first_of("\"\n", at);
        if (end != std::string::npos && text[end] == '"') names.insert(text.substr(at, end - at));
    }
    return names;
}

// The library file that defines one of the functions of a user's file, and which.
struct Place {
    std::string library, function;
};

std::vector<Place> places_of(const std::map<std::string, std::string>& texts, const std::string& user_text) {
    std::vector<Place> places;
    const auto functions = functions_of(user_text);
    for (const auto& [name, text] : texts) {
        if (!name.starts_with("lib/")) continue;
        for (const FunctionText& own : functions_of(text))
            if (std::ranges::find(functions, own.name, &FunctionText::name) != functions.end()) places.push_back({name, own.name});
    }
    return places;
}

} // namespace

ShaderTree::ShaderTree(fs::path root, std::vector<fs::path> replacements) : root_(std::move(root)), replacements_(std::move(replacements)) {
    for (const fs::path& file : replacements_) user_files_[fmt::format("user/{}-{}", user_files_.size(), file.filename().string())] = file;
    refresh();
}

std::vector<std::string> ShaderTree::refresh() {
    std::map<std::string, std::string> texts;
    std::error_code ignored;
    for (auto entry = fs::recursive_directory_iterator(root_, ignored); entry != fs::recursive_directory_iterator();
         entry.increment(ignored))
        if (entry->is_regular_file(ignored) && is_source(entry->path()))
            texts[entry->path().lexically_relative(root_).generic_string()] = text_of(entry->path());
    for (const auto& [name, file] : user_files_) texts[name] = text_of(file);
    std::vector<std::string> changed;
    for (const auto& [name, text] : texts)
        if (const auto before = texts_.find(name); before == texts_.end() || before->second != text) changed.push_back(name);
    for (const auto& [name, text] : texts_)
        if (!texts.contains(name)) changed.push_back(name);
    texts_ = std::move(texts);
    return changed;
}

std::set<std::string> ShaderTree::dependents(std::span<const std::string> files) const {
    std::set<std::string> reached(files.begin(), files.end());
    for (const std::string& file : files) // a user's function is part of the library that it stands in
        if (user_files_.contains(file))
            for (const Place& place : places_of(texts_, texts_.at(file))) reached.insert(place.library);
    for (bool grew = true; grew;) {
        grew = false;
        for (const auto& [name, text] : texts_) {
            if (reached.contains(name)) continue;
            const auto includes = includes_of(text);
            const bool reaches = std::ranges::any_of(includes, [&](const std::string& i) {
                return reached.contains(i) || reached.contains((fs::path(name).parent_path() / i).generic_string());
            });
            if (reaches) reached.insert(name), grew = true;
        }
    }
    std::set<std::string> entry_points;
    for (const auto& code : lightbench_shaders_table())
        if (reached.contains(std::string(code.name))) entry_points.emplace(code.name);
    return entry_points;
}

std::set<std::string> ShaderTree::replaced() const {
    std::vector<std::string> names;
    for (const auto& [name, file] : user_files_) names.push_back(name);
    return dependents(names);
}

// A file that replaces nothing is a mistake: its functions would never be called.
std::map<std::string, std::string> ShaderTree::stage_texts(CompiledShaders& result) const {
    std::map<std::string, std::string> staged = texts_;
    for (const auto& [name, file] : user_files_) {
        const auto places = places_of(texts_, texts_.at(name));
        if (places.empty()) result.errors.push_back({file.string(), 0, "defines no function of the name of one below shaders/lib/", ""});
        for (std::size_t i = 0; i < places.size(); ++i) {
            // Included once, where the first of its functions stands; of the others the originals step aside there too.
            const std::string include = i == 0 ? name : "user/none.glsl";
            staged[places[i].library] = replace_function(staged[places[i].library], places[i].function, include).value();
        }
    }
    staged["user/none.glsl"] = "";
    for (auto& [name, text] : staged) {
        const auto user = user_files_.find(name);
        text =
            with_sliders(text, user != user_files_.end() ? user->second.string() : (root_ / name).string(), result.sliders, result.errors);
    }
    return staged;
}

fs::path find_shader_sources() {
    std::vector<fs::path> places;
    if (const char* named = std::getenv("LIGHTBENCH_SHADERS")) places.emplace_back(named);
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty()) places.push_back(program.parent_path().parent_path() / "share/lightbench/shaders");
    places.emplace_back(LIGHTBENCH_SOURCE "/shaders");
    for (const fs::path& place : places)
        if (fs::is_directory(place, ignored)) return place;
    return {};
}

} // namespace lightbench
