// Meshes and single polygons as faces: equal positions welded, repeated points dropped, the file's own normals checked and kept.
#pragma once

#include "scene/scene.h"
#include "scene/tessellate_faces.h"
#include "scene/tessellate_placement.h"

namespace lightbench {

// What is found out once a mesh, however many objects place it.
struct WeldedMesh {
    std::vector<std::uint32_t> point_of_vertex; // vertices at exactly the same position are one point
    std::uint32_t point_count = 0;
    // Every edge is run along twice, once each way, and each connected part has a positive volume: no back can be seen from outside.
    bool closed = false;
};
WeldedMesh weld(const Mesh& mesh);

struct FileFaces {
    Faces faces;             // corners without a usable normal of the file have none; of zero area: still there
    std::vector<bool> kept;  // one a normal: the file's own
    std::size_t dropped = 0; // faces of fewer than 3 different points
};
// `detail`: with the texture points of a mesh that has uvs.
FileFaces mesh_faces(const Mesh& mesh, const WeldedMesh& welded, const Placement& placement, bool normals, bool detail = false);
FileFaces polygon_faces(const Polygon& polygon, const Placement& placement, bool normals);

// Removes the faces whose normal is 0, and their normals; returns how many there were.
std::size_t drop_degenerate(Faces& faces, std::vector<glm::dvec3>& of_faces);

} // namespace lightbench
