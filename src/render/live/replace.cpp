#include "render/live/replace.h"

#include "render/live/shader_text.h"
#include "scene/nearest.h"

#include <algorithm>
#include <fmt/ranges.h>

namespace lightbench {

namespace fs = std::filesystem;

namespace {

bool is_library(const std::string& name) {
    return name.starts_with("lib/");
}

bool is_blank(const std::string& text) {
    return text.find_first_not_of(" \t\r\n") == text.npos;
}

// Textbook formulas (lib/naive) are there for comparison: no picture calls them.
std::string nothing_to_replace(const Sources& sources, const std::string& user_text) {
    const auto functions = functions_of(user_text);
    if (is_blank(user_text)) return "is empty; it must define a function of the name of one below shaders/lib/";
    std::vector<std::string> names, library;
    for (const FunctionText& f : functions) names.push_back(f.name);
    for (const auto& [name, text] : sources.texts)
        if (is_library(name) && !name.starts_with("lib/naive/"))
            for (const FunctionText& f : functions_of(text)) library.push_back(f.name);
    std::ranges::sort(library);
    library.erase(std::ranges::unique(library).begin(), library.end());
    const std::vector<std::string_view> known(library.begin(), library.end());
    const std::string begin =
        names.empty() ? "defines no function of the name of one below shaders/lib/"
                      : fmt::format("defines {}, but no function of the name of one below shaders/lib/", fmt::join(names, ", "));
    for (const std::string& name : names)
        if (const auto near = nearest_name(name, known)) return fmt::format("{}; did you mean \"{}\"?", begin, *near);
    return fmt::format("{}: {}", begin, fmt::join(known, ", "));
}

struct Replacing {
    const Sources& sources;
    const fs::path& root;
    Replaced& out;
    std::map<std::string, std::string> taken; // function: name of the file that has it

    void fault(const std::string& name, unsigned line, std::string message) {
        const std::string text = line > 0 ? line_of(sources.texts.at(name), line) : "";
        out.errors.push_back({sources.user_files.at(name).string(), line, std::move(message), text});
        out.faulty.push_back(name);
    }
    void take(const std::string& name);
    bool fits(const std::string& name, const Place& place);
};

// Callers are compiled for the library's types: one of the user's overloads must have them.
bool Replacing::fits(const std::string& name, const Place& place) {
    const std::string &text = sources.texts.at(name), &library = sources.texts.at(place.library);
    const auto functions = functions_of(text), originals = functions_of(library);
    for (const FunctionText& own : functions)
        for (const FunctionText& original : originals)
            if (own.name == place.function && original.name == own.name && own.signature == original.signature) return true;
    const auto own = std::ranges::find(functions, place.function, &FunctionText::name);
    const auto original = std::ranges::find(originals, place.function, &FunctionText::name);
    fault(name, line_number(text, own->name_at),
          fmt::format("{} must be {}, as in {}:{}", place.function, original->head, (root / place.library).string(),
                      line_number(library, original->name_at)));
    return false;
}

void Replacing::take(const std::string& name) {
    const std::string& text = sources.texts.at(name);
    if (const auto why = sources.faults.find(name); why != sources.faults.end()) return fault(name, 0, why->second);
    const auto places = places_of(sources.texts, text);
    if (places.empty()) return fault(name, 0, nothing_to_replace(sources, text));
    bool first = true;
    std::set<std::string> misfits;
    for (const Place& place : places) {
        const auto owner = taken.emplace(place.function, name).first;
        if (owner->second != name) {
            const auto functions = functions_of(text);
            const auto f = std::ranges::find(functions, place.function, &FunctionText::name);
            fault(name, line_number(text, f->name_at),
                  fmt::format("{} is defined in both {} and {}; one file must define it", place.function,
                              sources.user_files.at(owner->second).string(), sources.user_files.at(name).string()));
            return;
        }
        if (misfits.contains(place.function)) continue;
        if (!fits(name, place)) misfits.insert(place.function);
        // Included once, where the first of its functions stands; of the others the originals step aside there too.
        auto next = replace_function(out.texts.at(place.library), place.function, first ? name : "user/none.glsl");
        if (next) out.texts[place.library] = std::move(*next);
        first = false;
    }
}

} // namespace

std::vector<Place> places_of(const std::map<std::string, std::string>& texts, const std::string& user_text) {
    std::vector<Place> places;
    const auto functions = functions_of(user_text);
    if (functions.empty()) return places;
    for (const auto& [name, text] : texts) {
        if (!is_library(name)) continue;
        for (const FunctionText& own : functions_of(text))
            if (std::ranges::find(functions, own.name, &FunctionText::name) != functions.end()) places.push_back({name, own.name});
    }
    return places;
}

Replaced replace_functions(const Sources& sources, const std::map<std::string, fs::path>& replacements, const fs::path& root) {
    Replaced out{sources.texts, {}, {}};
    Replacing replacing{sources, root, out, {}};
    for (const auto& [name, file] : replacements) replacing.take(name);
    out.texts["user/none.glsl"] = "";
    return out;
}

} // namespace lightbench
