#include "render/live/shader_tree.h"

#include "render/live/compiler_errors.h"
#include "render/live/replace.h"
#include "render/live/shader_includes.h"
#include "render/live/source_file.h"
#include "render/shaders.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fmt/format.h>
#include <optional>
#include <sys/stat.h>

namespace lightbench {

namespace fs = std::filesystem;

namespace {

bool is_source(const fs::path& file) {
    static const std::set<std::string> known = {".glsl", ".vert", ".frag", ".comp", ".h"};
    return known.contains(file.extension().string());
}

// None: not a regular file.
std::optional<FileStamp> stamp_of(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    const std::int64_t changed = std::int64_t{status.st_ctim.tv_sec} * 1'000'000'000 + status.st_ctim.tv_nsec;
    return FileStamp{changed, static_cast<std::uint64_t>(status.st_size), status.st_ino};
}

// Clocks of file systems are as coarse as two seconds (FAT).
bool is_fresh(const FileStamp& stamp) {
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    return now.tv_sec - stamp.changed / 1'000'000'000 < 3;
}

void put(Sources& sources, const std::string& name, SourceFile read) {
    if (!read.fault.empty()) sources.faults[name] = std::move(read.fault);
    sources.texts[name] = std::move(read.text);
}

// A user's file, and what it includes that lies beside or below it. What lies below the root is the tree's own.
void read_user(Sources& sources, const std::string& name, const fs::path& file, const fs::path& root) {
    if (sources.texts.contains(name)) return;
    put(sources, name, read_source(file));
    sources.user_files[name] = file;
    const std::string own = name.substr(0, name.find('/', 5) + 1); // "user/0/"
    for (const Include& include : includes_of(sources.texts.at(name))) {
        const fs::path beside = file.parent_path() / include.name;
        const std::string staged = (fs::path(name).parent_path() / include.name).lexically_normal().generic_string();
        std::error_code ignored;
        if (!staged.starts_with(own) || !fs::exists(beside, ignored) || fs::equivalent(beside, root / include.name, ignored)) continue;
        read_user(sources, staged, beside, root);
    }
}

} // namespace

ShaderTree::ShaderTree(fs::path root, std::vector<fs::path> replacements) : root_(std::move(root)) {
    for (const fs::path& file : replacements)
        replacements_[fmt::format("user/{}/{}", replacements_.size(), file.filename().string())] = file;
    refresh();
}

void ShaderTree::read_root(Sources& sources, Stamps& stamps) const {
    std::error_code ignored;
    for (auto entry = fs::recursive_directory_iterator(root_, ignored); entry != fs::recursive_directory_iterator();
         entry.increment(ignored)) {
        if (!is_source(entry->path())) continue;
        const std::string name = entry->path().lexically_relative(root_).generic_string();
        const std::optional<FileStamp> now = stamp_of(entry->path());
        if (!now) continue;
        const auto known = stamps_.find(name);
        if (known != stamps_.end() && known->second == *now && !sources_.faults.contains(name))
            sources.texts[name] = sources_.texts.at(name);
        else
            put(sources, name, read_source(entry->path()));
        if (!is_fresh(*now)) stamps[name] = *now;
    }
}

Sources ShaderTree::read(Stamps& stamps) const {
    Sources sources;
    read_root(sources, stamps);
    for (const auto& [name, file] : replacements_) read_user(sources, name, file, root_);
    return sources;
}

bool ShaderTree::is_stale() const {
    Stamps stamps;
    return read(stamps) != sources_;
}

std::vector<std::string> ShaderTree::refresh() {
    Stamps stamps;
    Sources next = read(stamps);
    stamps_ = std::move(stamps);
    const auto at = [](const std::map<std::string, std::string>& texts, const std::string& name) {
        const auto found = texts.find(name);
        return found == texts.end() ? std::optional<std::string>() : found->second;
    };
    std::set<std::string> changed;
    for (const Sources* some : {&sources_, &next})
        for (const auto& [name, text] : some->texts)
            if (at(next.texts, name) != at(sources_.texts, name) || at(next.faults, name) != at(sources_.faults, name))
                changed.insert(name);
    sources_ = std::move(next);
    return {changed.begin(), changed.end()};
}

std::vector<std::string> ShaderTree::edited() const {
    std::vector<std::string> names;
    std::set<std::string_view> known;
    for (const ShaderSource& source : built_in_sources()) {
        known.insert(source.name);
        const auto text = sources_.texts.find(std::string(source.name));
        if (text == sources_.texts.end() || text->second != source.text) names.emplace_back(source.name);
    }
    for (const auto& [name, text] : sources_.texts)
        if (!known.contains(name) && !name.starts_with("user/") && !name.starts_with("numerics/")) names.push_back(name);
    return names;
}

std::set<std::string> ShaderTree::dependents(std::span<const std::string> files) const {
    std::set<std::string> reached(files.begin(), files.end());
    for (std::size_t before = 0; before != reached.size();) {
        before = reached.size();
        for (const auto& [name, text] : sources_.texts)
            if (!reached.contains(name) && std::ranges::any_of(includes_of(text), [&](const Include& include) {
                    return reached.contains(include.name) ||
                           reached.contains((fs::path(name).parent_path() / include.name).lexically_normal().generic_string());
                }))
                reached.insert(name);
        for (const auto& [name, file] : replacements_) // a user's function is part of the library that it stands in
            if (reached.contains(name))
                for (const Place& place : places_of(sources_.texts, sources_.texts.at(name))) reached.insert(place.library);
    }
    std::set<std::string> entry_points;
    for (const auto& code : lightbench_shaders_table())
        if (reached.contains(std::string(code.name))) entry_points.emplace(code.name);
    return entry_points;
}

std::set<std::string> ShaderTree::replaced() const {
    std::vector<std::string> names;
    for (const auto& [name, file] : replacements_) names.push_back(name);
    return dependents(names);
}

std::map<std::string, std::string> ShaderTree::stage_texts(CompiledShaders& result, std::set<std::string>& spoilt) const {
    Replaced replaced = replace_functions(sources_, replacements_, root_);
    result.errors = std::move(replaced.errors);
    std::vector<std::string> faulty = std::move(replaced.faulty);
    const Origins origins{root_, sources_.user_files, sources_.texts, ""};
    for (const auto& [name, fault] : sources_.faults)
        if (!replacements_.contains(name) && !dependents({&name, 1}).empty())
            result.errors.push_back(origins.error_at(name, 0, fault)), faulty.push_back(name);
    for (const Circle& circle : circles(sources_.texts))
        if (!dependents({&circle.file, 1}).empty())
            result.errors.push_back(origins.error_at(circle.file, circle.line, circle.message)), faulty.push_back(circle.file);
    spoilt = dependents(faulty);
    for (auto& [name, text] : replaced.texts) text = with_sliders(text, origins.error_at(name, 0, "").file, result.sliders, result.errors);
    return std::move(replaced.texts);
}

fs::path find_shader_sources() {
    std::vector<fs::path> places;
    if (const char* named = std::getenv("LIGHTBENCH_SHADERS"); named != nullptr && *named != '\0') return named;
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty()) places.push_back(program.parent_path().parent_path() / "share/lightbench/shaders");
    places.emplace_back(LIGHTBENCH_SOURCE "/shaders");
    for (const fs::path& place : places)
        if (fs::is_directory(place, ignored)) return place;
    return {};
}

} // namespace lightbench
