// What the parts of the TOML loader share: one load in progress, and the reader of each kind of section. Only toml*.cpp include this.
#pragma once

#include "scene/load.h"
#include "scene/scene.h"
#include "scene/toml_section.h"

#include <map>
#include <string>
#include <string_view>

namespace lightbench {

// An imported file whose materials, meshes and pictures are already in the scene, ready to be placed once more.
struct Placed {
    std::vector<Object> objects;                  // indices are of the whole scene
    std::map<std::uint32_t, std::uint32_t> plain; // mesh -> its copy without materials of its own, for objects that give one
    bool usable = false;
};

struct TomlLoad {
    std::string file; // as typed, for messages
    std::filesystem::path folder;
    LoadOptions options;
    ProblemLog log;
    Scene scene;
    std::map<std::string, std::uint32_t, std::less<>> materials; // by name
    std::map<std::string, unsigned, std::less<>> material_lines; // where each name was given first
    std::map<std::string, std::uint32_t> pictures;               // by path
    std::map<std::string, Placed> placed;                        // by path
};

Section section_of(TomlLoad& load, const toml::table& table, std::string who);

// A file named by a key: resolved, or a problem. False if the key is absent or wrong.
bool read_file_name(TomlLoad& load, Section& section, std::string_view key, std::filesystem::path& out);
bool file_of(TomlLoad& load, const Section& section, const toml::node& node, std::string_view name, std::filesystem::path& out);
std::uint32_t picture_index(TomlLoad& load, const std::filesystem::path& path);

void read_film(TomlLoad& load, const toml::table& table);
void read_camera(TomlLoad& load, const toml::table& table);
void read_environment(TomlLoad& load, const toml::table& table);
void read_light(TomlLoad& load, const toml::table& table);
void read_material(TomlLoad& load, const toml::table& table);
void read_object(TomlLoad& load, const toml::table& table);

// The shape named by `shape`, with the keys of that shape; false if it cannot be used. Not for "mesh".
bool read_shape(Section& section, std::string_view shape, Shape& out);

// The objects of the file at `path`, with world_from_object on top of their own transforms; `material` replaces their own if it is given.
struct Placing {
    std::uint32_t transform = 0;
    std::optional<std::uint32_t> material;
    std::optional<float> crease;
    std::optional<std::uint8_t> subdivide;
};
void place_file(TomlLoad& load, const Section& section, const toml::node& where, const std::filesystem::path& path, const Placing& placing);

} // namespace lightbench
