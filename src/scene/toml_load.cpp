// The sections of a native scene file, in an order in which names are known before they are used.
#include "scene/toml_load.h"

#include "scene/load_default.h"
#include "scene/paths.h"
#include "scene/toml_guard.h"
#include "scene/toml_parts.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

using ReadOne = void (*)(TomlLoad&, const toml::table&);

void wrong_section(Section& top, const toml::node& node, std::string_view key, std::string_view wanted) {
    fault(top, node, fmt::format("{} is {}; write {}", key, kind_name(node), wanted));
}

// [film]
void read_single(TomlLoad& load, Section& top, std::string_view key, ReadOne read_one) {
    const toml::node* node = find(top, key);
    if (!node) return;
    if (const toml::table* table = node->as_table())
        read_one(load, *table);
    else
        wrong_section(top, *node, key, fmt::format("one [{}]", key));
}

// [[light]]; [camera] may stand alone
void read_several(TomlLoad& load, Section& top, std::string_view key, ReadOne read_one, std::size_t limit,
                  bool one_may_stand_alone = false) {
    const toml::node* node = find(top, key);
    if (!node) return;
    if (const toml::table* table = node->as_table(); table && one_may_stand_alone) return read_one(load, *table);
    const toml::array* array = node->as_array();
    if (!array) return wrong_section(top, *node, key, fmt::format("[[{}]]", key));
    if (array->size() > limit) return fault(top, *node, fmt::format("{} of {}; the limit is {}", array->size(), key, limit));
    for (const toml::node& element : *array) {
        if (const toml::table* table = element.as_table())
            read_one(load, *table);
        else
            wrong_section(top, element, key, fmt::format("[[{}]]", key));
    }
}

void read_sections(TomlLoad& load, const toml::table& root) {
    Section top = section_of(load, root, "scene");
    read_single(load, top, "film", read_film);
    read_several(load, top, "camera", read_camera, limits::kMaxLights, true);
    read_single(load, top, "environment", read_environment);
    read_several(load, top, "light", read_light, limits::kMaxLights);
    read_several(load, top, "material", read_material, limits::kMaxMaterials);
    read_several(load, top, "object", read_object, limits::kMaxObjects);
    report_unknown_keys(top);
    if (load.scene.materials.empty()) load.scene.materials.push_back(default_material());
}

void parse(TomlLoad& load, std::string_view text) {
    if (const auto guarded = toml_fault(text)) {
        report(load.log, load.file, guarded->line, guarded->column, guarded->text);
        return;
    }
    try {
        read_sections(load, toml::parse(text));
    } catch (const toml::parse_error& error) {
        const toml::source_position at = error.source().begin;
        report(load.log, load.file, at.line, at.column, fmt::format("not valid TOML: {}", error.description()));
    }
}

} // namespace

Section section_of(TomlLoad& load, const toml::table& table, std::string who) {
    return {&table, std::move(who), load.file, &load.log, {}};
}

bool file_of(TomlLoad& load, const Section& section, const toml::node& node, std::string_view name, std::filesystem::path& out) {
    const auto* text = node.as_string();
    if (!text) {
        fault(section, node, fmt::format("{} is {}; it must be a string", name, kind_name(node)));
        return false;
    }
    Resolved resolved = resolve_file(load.folder, text->get(), load.options.allow_outside);
    if (!resolved.why.empty()) fault(section, node, fmt::format("{} {}: {}", name, in_quotes(text->get()), resolved.why));
    out = std::move(resolved.path);
    return resolved.why.empty();
}

bool read_file_name(TomlLoad& load, Section& section, std::string_view key, std::filesystem::path& out) {
    const toml::node* node = find(section, key);
    return node && file_of(load, section, *node, key, out);
}

std::uint32_t picture_index(TomlLoad& load, const std::filesystem::path& path) {
    const auto [entry, added] = load.pictures.try_emplace(path.string(), static_cast<std::uint32_t>(load.scene.pictures.size()));
    if (added) load.scene.pictures.push_back({path, {}});
    return entry->second;
}

Loaded load_toml(std::string_view text, const std::filesystem::path& file, const LoadOptions& options) {
    TomlLoad load;
    load.file = file.string();
    load.folder = folder_of(file);
    load.options = options;
    load.log.max = options.max_problems;
    load.scene.name = file.filename().string();
    parse(load, text);
    if (!load.log.empty()) return {std::nullopt, listed(load.log, load.file), load.log.unlisted};
    return {std::move(load.scene), {}, 0};
}

} // namespace lightbench
