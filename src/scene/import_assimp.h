// Assimp, held to one importer and to bytes in memory: it can neither guess another format nor open a file.
// In: the bytes, under the names by which the importer asks for them. Out: Assimp's scene as it read it, nothing computed or triangulated.
#pragma once

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <variant>

namespace lightbench::importer {

enum class ImportFormat { obj, gltf, ply, stl };

using MemoryFiles = std::map<std::string, std::span<const std::uint8_t>>; // file name without folders -> content

// Owns what it read.
struct AssimpScene {
    std::unique_ptr<Assimp::Importer> importer;
    const aiScene* scene = nullptr;
};

// Reads `main` of `files`, or says in one sentence why Assimp refuses it. Throws std::bad_alloc where memory ran out.
std::variant<AssimpScene, std::string> read_with_assimp(ImportFormat format, const std::string& main, const MemoryFiles& files);

} // namespace lightbench::importer
