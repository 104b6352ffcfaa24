// From Assimp's meshes, one per material with a vertex per corner, to ours: polygons that share vertices across materials.
// In: the meshes of one node, in file order, with their materials. Out: at most two meshes: faces with the file's own normals, and faces
// without. Polygons stay whole; points and lines, and faces that cannot be drawn, are dropped and counted.
#pragma once

#include "scene/import_report.h"
#include "scene/scene.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

struct aiMesh;

namespace lightbench::importer {

struct MeshPart {
    const aiMesh* mesh = nullptr;
    std::uint32_t material = 0; // index into Scene::materials
};

struct ImportedMesh {
    Mesh mesh;                  // face_materials only where there is more than one
    std::uint32_t material = 0; // of the object, otherwise
};

// Vertices are one where position, normal, uv and tangent are bit for bit the same (-0 is 0). A face keeps its normals if all of them are usable.
// Without `keep_normals` the file's normals are those of facets and say nothing (STL). What is wrong goes into `report`.
std::vector<ImportedMesh> weld(std::span<const MeshPart> parts, bool keep_normals, const std::string& name, Report& report);

} // namespace lightbench::importer
