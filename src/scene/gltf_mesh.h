// Geometry of glTF 2.0. In: the checked document, the meshes that are used. Out: each as one welded mesh (two, if some of its faces have no
// normals), decoded by Assimp from a document that holds nothing but geometry under names of our own.
#pragma once

#include "scene/gltf_document.h"

#include <map>
#include <set>
#include <vector>

namespace lightbench::importer {

struct GltfMeshUse {
    std::uint32_t mesh = 0; // index into Scene::meshes
    std::uint32_t material = 0;
};

// By index of the mesh in the file. Assimp sees no material, no node, no picture and no extension, so it can neither mistake nor refuse them.
std::map<std::size_t, std::vector<GltfMeshUse>> add_gltf_meshes(ImportJob& job, const GltfDocument& document,
                                                                const std::set<std::size_t>& used);

} // namespace lightbench::importer
