// What the writers of the formats share: the problems found on the way, and bytes put on disk whole or not at all. Only write*.cpp include this.
#pragma once

#include "scene/write.h"

#include <string>
#include <string_view>

namespace lightbench {

// One problem a cause: what the format cannot express, how often it was met, and the first object (or light, or material) that has it.
struct WriteLog {
    struct Entry {
        std::string what, instead, first;
        std::size_t count = 0;
    };
    std::string file;
    std::vector<Entry> entries;
};

void refuse(WriteLog& log, std::string_view what, std::string_view instead, std::string_view where);
Problems problems_of(const WriteLog& log);

// Each line of the text behind a #.
std::string comment_lines(std::string_view text);

// Written beside the file and renamed. Throws std::system_error with the file's name.
void put_file(const std::filesystem::path& file, std::string_view bytes);

// Each returns the bytes of the file, and logs what it cannot express.
std::string toml_text(const Scene& scene, const std::filesystem::path& file, std::string_view comment, WriteLog& log);
std::string nff_text(const Scene& scene, std::string_view comment, WriteLog& log);
Mesh merged_mesh(const Scene& scene, WriteLog& log);
std::string obj_text(const Mesh& mesh, std::string_view comment);
std::string ply_bytes(const Mesh& mesh);

// Where a TOML scene puts mesh number i: beside it, under the scene's name.
std::filesystem::path mesh_file(const Scene& scene, std::size_t i, const std::filesystem::path& scene_file);
std::string mesh_bytes(const Mesh& mesh, const std::filesystem::path& file);

} // namespace lightbench
