// What tests of the program write and read: a small scene, whole files.
#pragma once

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <string>

namespace lightbench {

// A red ball, one point light, a camera. `more`: tables of the file; `material`: lines of the ball's.
inline std::string ball_scene(unsigned width, unsigned height, const std::string& more = "", const std::string& material = "") {
    constexpr const char* text = R"([film]
width = {}
height = {}
[camera]
name = "front"
position = [0, 1, 5]
target = [0, 0, 0]
{}[[light]]
type = "point"
position = [3, 4, 5]
intensity = 6
[[material]]
name = "red"
diffuse = [0.7, 0.1, 0.1]
specular = 0.5
shininess = 20
{}[[object]]
shape = "sphere"
material = "red"
radius = 1.0
)";
    return fmt::format(text, width, height, more, material);
}

inline std::string read_text(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

} // namespace lightbench
