// Small files for tests of the import: written into a folder of their own, imported, and the parts of glTF put together.
#pragma once

#include "scene/import.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace lightbench::importer_test {

// A folder that goes when the test ends.
struct Folder {
    std::filesystem::path path;
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "import_XXXXXX").string();
        path = mkdtemp(pattern.data());
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path write(const std::string& name, std::string_view content) const {
        std::filesystem::create_directories((path / name).parent_path());
        std::ofstream(path / name, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
        return path / name;
    }
};

inline std::string all_problems(const Loaded& loaded) {
    std::string text;
    for (const Problem& problem : loaded.problems) text += to_string(problem) + "\n";
    return text;
}

inline std::string all_remarks(const Loaded& loaded) {
    std::string text;
    if (loaded.scene)
        for (const std::string& remark : loaded.scene->remarks) text += remark + "\n";
    return text;
}

inline Loaded import_text(const std::string& name, std::string_view content) {
    const Folder folder;
    return import_file(folder.write(name, content));
}

// The corners of a face by position, which no numbering of vertices can change.
inline std::vector<glm::vec3> corners(const Mesh& mesh, std::size_t face) {
    std::vector<glm::vec3> points;
    for (std::uint32_t i = mesh.face_starts.at(face); i < mesh.face_starts.at(face + 1); ++i)
        points.push_back(mesh.positions.at(mesh.corners.at(i)));
    return points;
}

template <class T> void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T> std::string packed(std::initializer_list<T> values) {
    std::string bytes;
    for (const T& value : values) append(bytes, value);
    return bytes;
}

inline std::string base64(std::string_view bytes) {
    constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto at = [&](std::size_t k) { return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u; };
        const unsigned three = at(0) << 16 | at(1) << 8 | at(2);
        for (int k = 0; k < 4; ++k) text += i + static_cast<std::size_t>(k) <= bytes.size() ? kAlphabet[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

// One triangle (0,0,0) (1,0,0) (0,1,0) with 16-bit indices 0 1 2, as buffer, views and accessors 0 (positions) and 1 (indices).
inline std::string triangle_bytes() {
    return packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + packed<std::uint16_t>({0, 1, 2});
}

inline std::string triangle_parts(const std::string& uri) {
    return R"("buffers":[{"byteLength":42)" + (uri.empty() ? "" : R"(,"uri":")" + uri + "\"") +
           R"(}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}])";
}

inline std::string triangle_uri() {
    return "data:application/octet-stream;base64," + base64(triangle_bytes());
}

// A glTF of that triangle as mesh 0; `rest` holds nodes and whatever else the test wants.
inline std::string triangle_gltf(const std::string& rest, const std::string& primitive = "") {
    return R"({"asset":{"version":"2.0"},)" + triangle_parts(triangle_uri()) +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1)" + primitive + "}]}]," + rest + "}";
}

} // namespace lightbench::importer_test
