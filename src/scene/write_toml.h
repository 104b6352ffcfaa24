// The TOML writer in progress, and the words its parts share. Only write_toml*.cpp include this.
#pragma once

#include "scene/write_parts.h"

#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

struct TomlWriter {
    const Scene& scene;
    const std::filesystem::path& file;
    WriteLog& log;
    std::string out;
    std::vector<std::string> materials; // the name of each, unique
};

void begin_section(TomlWriter& w, std::string_view head);
void key(TomlWriter& w, std::string_view name, std::string_view value);

std::string toml(const glm::dvec3& v);
std::string toml_color(const glm::vec3& c); // one number where all channels are equal
std::string quoted_toml(std::string_view text);
std::string picture_name(TomlWriter& w, std::uint32_t index, std::string_view where);

void write_material(TomlWriter& w, std::size_t index);
void write_object(TomlWriter& w, std::size_t index);

} // namespace lightbench
