// Reads the faces of meshes and polygons; finds out which meshes are closed. In: a mesh. Out: welded points, faces.
#include "scene/tessellate_mesh.h"

#include <algorithm>
#include <cmath>
#include <meshoptimizer.h>
#include <numeric>

namespace lightbench {
namespace {

// A half edge, kept with the lower of its points.
struct HalfEdge {
    std::uint32_t to;
    bool up; // runs from the lower point to the higher
    auto operator<=>(const HalfEdge&) const = default;
};

// Calls visit(from, to) for every edge of every face, skipping edges without length.
template <typename Visit> void each_edge(const Mesh& mesh, const std::vector<std::uint32_t>& point_of, Visit visit) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t i = mesh.face_starts[f], end = mesh.face_starts[f + 1]; i < end; ++i) {
            const std::uint32_t from = point_of[mesh.corners[i]], to = point_of[mesh.corners[i + 1 < end ? i + 1 : mesh.face_starts[f]]];
            if (from != to) visit(from, to);
        }
}

bool edges_pair_up(const Mesh& mesh, const WeldedMesh& welded) {
    std::vector<std::uint32_t> starts(welded.point_count + 1, 0);
    each_edge(mesh, welded.point_of_vertex, [&](std::uint32_t a, std::uint32_t b) { ++starts[std::min(a, b) + 1]; });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<HalfEdge> halves(starts.back());
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    each_edge(mesh, welded.point_of_vertex, [&](std::uint32_t a, std::uint32_t b) {
        halves[next[std::min(a, b)]++] = {std::max(a, b), a < b};
    });
    for (std::size_t p = 0; p + 1 < starts.size(); ++p) {
        const auto first = halves.begin() + starts[p], last = halves.begin() + starts[p + 1];
        if ((last - first) % 2 != 0) return false;
        std::sort(first, last);
        for (auto e = first; e != last; e += 2)
            if (e[0].to != e[1].to || e[0].up == e[1].up || (e + 2 != last && e[2].to == e[0].to)) return false;
    }
    return starts.back() > 0;
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

std::vector<glm::dvec3> welded_points(const Mesh& mesh, const WeldedMesh& welded, const glm::dmat3& linear) {
    std::vector<glm::dvec3> points(welded.point_count);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) points[welded.point_of_vertex[i]] = linear * glm::dvec3(mesh.positions[i]);
    return points;
}

// Signed volumes by the divergence theorem, each part about a point of its own, so that a part far from the origin loses nothing.
bool parts_have_volume(const Mesh& mesh, const WeldedMesh& welded) {
    const auto points = welded_points(mesh, welded, glm::dmat3(1));
    std::vector<std::uint32_t> parent(welded.point_count);
    std::iota(parent.begin(), parent.end(), 0u);
    each_edge(mesh, welded.point_of_vertex, [&](std::uint32_t a, std::uint32_t b) { parent[root_of(parent, a)] = root_of(parent, b); });
    std::vector<double> volume(welded.point_count, 0);
    const auto point = [&](std::uint32_t corner) { return points[welded.point_of_vertex[mesh.corners[corner]]]; };
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (mesh.face_starts[f] == mesh.face_starts[f + 1]) continue;
        const std::uint32_t part = root_of(parent, welded.point_of_vertex[mesh.corners[mesh.face_starts[f]]]);
        const glm::dvec3 a = point(mesh.face_starts[f]);
        for (std::uint32_t i = mesh.face_starts[f] + 2; i < mesh.face_starts[f + 1]; ++i)
            volume[part] += glm::dot(a - points[part], glm::cross(point(i - 1) - a, point(i) - a));
    }
    for (std::uint32_t corner : mesh.corners)
        if (!(volume[root_of(parent, welded.point_of_vertex[corner])] > 0)) return false;
    return true;
}

// Appends a loop without repeats of a point in a row; false (and nothing appended) if fewer than 3 corners are left. `textures`: empty, or
// one a corner.
bool append_loop(Faces& faces, std::span<const Corner> loop, std::span<const std::uint32_t> textures = {}) {
    const std::size_t first = faces.corners.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (faces.corners.size() != first && faces.corners.back().point == loop[i].point) continue;
        faces.corners.push_back(loop[i]);
        if (!textures.empty()) faces.corner_textures.push_back(textures[i]);
    }
    while (faces.corners.size() > first + 1 && faces.corners.back().point == faces.corners[first].point) faces.corners.pop_back();
    if (faces.corners.size() < first + 3) faces.corners.resize(first);
    if (!textures.empty()) faces.corner_textures.resize(faces.corners.size());
    return faces.corners.size() > first ? faces.close_face(), true : false;
}

// The file's normals in world axes, made unit; those that are 0 or not finite are not kept.
void take_normals(FileFaces& made, const std::vector<glm::vec3>& normals, const Placement& placement) {
    made.faces.normals.resize(normals.size());
    made.kept.resize(normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const glm::dvec3 n = placement.normal * glm::dvec3(normals[i]);
        const double length = glm::length(n);
        made.kept[i] = length > 0 && std::isfinite(length);
        if (made.kept[i]) made.faces.normals[i] = n / length;
    }
}

template <typename T> void turn_if_mirrored(std::vector<T>& loop, const Placement& placement) {
    if (placement.mirrored && !loop.empty()) std::reverse(loop.begin() + 1, loop.end());
}

// A vertex's place in the pictures, as the file has it.
struct FileTexturePoint {
    glm::vec2 uv{0};
    glm::vec4 tangent{0};
};
static_assert(sizeof(FileTexturePoint) == 24, "hashed as bytes, so without padding");

// Vertices that agree in uv and tangent share a texture point. A mirror turns the way of v against cross(normal, tangent).
std::vector<std::uint32_t> take_texture_points(Faces& faces, const Mesh& mesh, const Placement& placement) {
    std::vector<FileTexturePoint> all(mesh.uvs.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = {mesh.uvs[i], mesh.tangents.empty() ? glm::vec4(0) : mesh.tangents[i]};
    std::vector<std::uint32_t> point_of(all.size());
    faces.texture_points.resize(
        meshopt_generateVertexRemap(point_of.data(), nullptr, all.size(), all.data(), all.size(), sizeof(FileTexturePoint)));
    for (std::size_t i = 0; i < all.size(); ++i) {
        const glm::dvec4 t(all[i].tangent);
        faces.texture_points[point_of[i]] = {all[i].uv, glm::dvec4(placement.linear * glm::dvec3(t), placement.mirrored ? -t.w : t.w)};
    }
    return point_of;
}

} // namespace

WeldedMesh weld(const Mesh& mesh) {
    WeldedMesh welded;
    std::vector<glm::vec3> positions = mesh.positions;
    for (auto& p : positions) p += glm::vec3(0); // -0 and 0 are the same place, but not the same bits
    welded.point_of_vertex.resize(positions.size());
    if (positions.empty()) return welded;
    welded.point_count = static_cast<std::uint32_t>(meshopt_generateVertexRemap(welded.point_of_vertex.data(), nullptr, positions.size(),
                                                                                positions.data(), positions.size(), sizeof(glm::vec3)));
    welded.closed = edges_pair_up(mesh, welded) && parts_have_volume(mesh, welded);
    return welded;
}

FileFaces mesh_faces(const Mesh& mesh, const WeldedMesh& welded, const Placement& placement, bool normals, bool detail) {
    FileFaces made;
    made.faces.points = welded_points(mesh, welded, placement.linear);
    if (normals) take_normals(made, mesh.normals, placement);
    made.faces.corners.reserve(mesh.corners.size());
    made.faces.starts.reserve(mesh.face_starts.size());
    std::vector<std::uint32_t> texture_of_vertex, textures;
    if (detail && !mesh.uvs.empty()) texture_of_vertex = take_texture_points(made.faces, mesh, placement);
    if (!texture_of_vertex.empty()) made.faces.corner_textures.reserve(mesh.corners.size());
    std::vector<Corner> loop;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        loop.clear(), textures.clear();
        for (std::uint32_t i = mesh.face_starts[f]; i < mesh.face_starts[f + 1]; ++i) {
            const std::uint32_t vertex = mesh.corners[i];
            loop.push_back({welded.point_of_vertex[vertex], vertex < made.kept.size() && made.kept[vertex] ? vertex : kNone});
            if (!texture_of_vertex.empty()) textures.push_back(texture_of_vertex[vertex]);
        }
        turn_if_mirrored(loop, placement);
        turn_if_mirrored(textures, placement);
        if (!append_loop(made.faces, loop, textures))
            ++made.dropped;
        else if (!mesh.face_materials.empty())
            made.faces.materials.push_back(mesh.face_materials[f]);
    }
    return made;
}

FileFaces polygon_faces(const Polygon& polygon, const Placement& placement, bool normals) {
    FileFaces made;
    if (normals) take_normals(made, polygon.normals, placement);
    std::vector<Corner> loop;
    for (std::uint32_t i = 0; i < polygon.points.size(); ++i) {
        const bool same = i > 0 && polygon.points[i] == polygon.points[i - 1];
        const auto point = static_cast<std::uint32_t>(made.faces.points.size() - (same ? 1 : 0));
        if (!same) made.faces.points.push_back(placement.linear * polygon.points[i]);
        loop.push_back({polygon.points[i] == polygon.points[0] ? 0 : point, i < made.kept.size() && made.kept[i] ? i : kNone});
    }
    turn_if_mirrored(loop, placement);
    made.dropped = append_loop(made.faces, loop) ? 0 : 1;
    return made;
}

std::size_t drop_degenerate(Faces& faces, std::vector<glm::dvec3>& of_faces) {
    std::size_t kept = 0, corners = 0;
    const std::size_t count = faces.count();
    for (std::size_t f = 0, start = 0; f < count; ++f) {
        const std::size_t end = faces.starts[f + 1];
        if (of_faces[f] != glm::dvec3(0)) {
            for (std::size_t i = start; i < end; ++i, ++corners) {
                faces.corners[corners] = faces.corners[i];
                if (!faces.corner_textures.empty()) faces.corner_textures[corners] = faces.corner_textures[i];
            }
            if (!faces.materials.empty()) faces.materials[kept] = faces.materials[f];
            if (!faces.hubs.empty()) faces.hubs[kept] = faces.hubs[f];
            of_faces[kept] = of_faces[f];
            faces.starts[++kept] = static_cast<std::uint32_t>(corners);
        }
        start = end;
    }
    faces.corners.resize(corners);
    if (!faces.corner_textures.empty()) faces.corner_textures.resize(corners);
    faces.starts.resize(kept + 1);
    of_faces.resize(kept);
    if (!faces.materials.empty()) faces.materials.resize(kept);
    if (!faces.hubs.empty()) faces.hubs.resize(kept);
    return count - kept;
}

} // namespace lightbench
