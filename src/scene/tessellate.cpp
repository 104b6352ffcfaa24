// Cuts every object into faces, normals, triangles and vertices, and fills the streams. In: Scene, request. Out: RasterGeometry.
#include "scene/tessellate.h"

#include "scene/limits.h"
#include "scene/normals.h"
#include "scene/primitive_meshes.h"
#include "scene/subdivide.h"
#include "scene/tessellate_facets.h"
#include "scene/tessellate_mesh.h"
#include "scene/tessellate_provoke.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <stdexcept>

namespace lightbench {
namespace {

constexpr unsigned kMaxSubdivide = 8;

// An eye nearer to the sphere about a shape than this part of its radius, or inside, is taken to be as near as this: what it sees of the
// shape's outline is farther than the nearest point, for the horizon of a sphere of radius r seen from a height h is sqrt(2 r h) away.
constexpr double kNearestPart = 1.0 / 16;

// Everything about the object at hand that its shape does not say.
struct Job {
    const Object* object = nullptr;
    std::uint32_t number = 0;
    Placement placement; // translation relative to the frame's origin, metres
    unsigned subdivide = 0;
    bool two_sided = false;
};

class Tessellator {
  public:
    Tessellator(const Scene& scene, const TessellationRequest& request) : scene_(scene), request_(request), meshes_(scene.meshes.size()) {
        geometry_.frame = frame_of(bounds_of(scene));
    }
    RasterGeometry run();

    void operator()(const Sphere& sphere);
    void operator()(const Polygon& polygon) { cut_file_faces(polygon_faces(polygon, job_.placement, request_.normals)); }
    void operator()(const Box& box);
    void operator()(const Cylinder& cylinder) { cut_cone(cone_of(cylinder)); }
    void operator()(const Cone& cone) { cut_cone(cone); }
    void operator()(const Torus& torus);
    void operator()(const MeshUse& use) {
        cut_file_faces(mesh_faces(scene_.meshes[use.mesh], welded(use.mesh), job_.placement, request_.normals));
    }

  private:
    const WeldedMesh& welded(std::uint32_t mesh);
    bool two_sided(const Object& object);
    void count(std::size_t triangles);
    void count_split(std::size_t triangles) { count(triangles << (2 * job_.subdivide)); }
    std::size_t face_triangles(const Shape& shape) const;
    double chord_error(const glm::dvec3& center, double radius) const;
    glm::dvec3 anchor_at(const glm::dvec3& center) const { return job_.placement.translation + job_.placement.linear * center; }
    void cut_cone(const Cone& cone);
    void cut_curved(Faces faces);
    void cut_file_faces(FileFaces file);
    void emit(const Facets& facets, const glm::dvec3& anchor, double scale);
    void emit_vertices(const Facets& facets, const glm::dvec3& anchor, double scale);
    void emit_polygons(const Facets& facets, const glm::dvec3& anchor, double scale);

    const Scene& scene_;
    const TessellationRequest& request_;
    Job job_;
    RasterGeometry geometry_;
    Soup one_sided_, two_sided_;
    std::vector<std::optional<WeldedMesh>> meshes_;
    std::map<std::uint32_t, Facets> spheres_; // of radius 1, by pieces
    std::size_t triangles_ = 0;
};

const WeldedMesh& Tessellator::welded(std::uint32_t mesh) {
    if (!meshes_[mesh]) meshes_[mesh] = weld(scene_.meshes[mesh]);
    return *meshes_[mesh];
}

bool is_closed_primitive(const Shape& shape) {
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return cylinder->capped;
    if (const auto* cone = std::get_if<Cone>(&shape)) return cone->capped;
    return !std::holds_alternative<Polygon>(shape);
}

bool Tessellator::two_sided(const Object& object) {
    const auto* use = std::get_if<MeshUse>(&object.shape);
    std::vector<std::uint32_t> materials{object.material};
    if (use && !scene_.meshes[use->mesh].face_materials.empty()) materials = scene_.meshes[use->mesh].face_materials;
    bool forbidden = true;
    for (std::uint32_t m : materials) {
        const auto& wanted = scene_.materials[m].two_sided;
        if (wanted.value_or(false)) return true;
        forbidden = forbidden && wanted.has_value();
    }
    if (forbidden) return false;
    return use ? !welded(use->mesh).closed : !is_closed_primitive(object.shape);
}

// Counted before anything is allocated.
void Tessellator::count(std::size_t triangles) {
    triangles_ += triangles;
    if (triangles_ > limits::kMaxTriangles)
        throw std::length_error(fmt::format("object {} brings the scene to {} triangles; the limit kMaxTriangles is {}: subdivide less, or "
                                            "render fewer objects",
                                            job_.number, triangles_, limits::kMaxTriangles));
}

// Before subdivision; every further level makes 4 of each, or fewer.
std::size_t Tessellator::face_triangles(const Shape& shape) const {
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return polygon->points.size() - 2;
    if (std::holds_alternative<Box>(shape)) return 12;
    const auto* use = std::get_if<MeshUse>(&shape);
    if (!use) return 0;
    const Mesh& mesh = scene_.meshes[use->mesh];
    std::size_t triangles = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) triangles += std::max(3u, mesh.face_starts[f + 1] - mesh.face_starts[f]) - 2;
    return triangles;
}

// The chord error allowed, in object units, for a shape within `radius` of `center`.
double Tessellator::chord_error(const glm::dvec3& center, double radius) const {
    const double world_radius = job_.placement.stretch * radius;
    const glm::dvec3 eye = request_.eye - geometry_.frame.origin;
    const double nearest = glm::length(anchor_at(center) - eye) - world_radius;
    const double error = request_.pixels * request_.pixel_angle * std::max(nearest, kNearestPart * world_radius);
    return job_.placement.stretch > 0 ? error / job_.placement.stretch : radius;
}

// Where all directions are scaled alike a sphere stays one, however it is turned: spheres of the same fineness share their facets.
void Tessellator::operator()(const Sphere& sphere) {
    const Cuts cuts = cuts_of(sphere, chord_error(sphere.center, sphere.radius), job_.subdivide);
    count(triangle_count(sphere, cuts));
    const glm::dvec3 anchor = anchor_at(sphere.center);
    if (job_.placement.similarity) {
        auto& known = spheres_[cuts.along];
        if (known.triangles.empty()) {
            const Faces faces = unit_sphere_faces(cuts.along);
            known = facets_of(faces, face_normals(faces), request_.normals);
        }
        return emit(known, anchor, *job_.placement.similarity * sphere.radius);
    }
    Faces faces = unit_sphere_faces(cuts.along);
    for (auto& p : faces.points) p *= sphere.radius;
    faces.anchor = anchor;
    cut_curved(std::move(faces));
}

void Tessellator::operator()(const Box& box) {
    FileFaces made;
    made.faces = box_faces(box);
    place(made.faces, job_.placement);
    made.faces.anchor = anchor_at(center_of(box)) - job_.placement.translation;
    cut_file_faces(std::move(made));
}

void Tessellator::cut_cone(const Cone& cone) {
    const double half = 0.5 * glm::length(cone.top - cone.base), radius = std::max(cone.base_radius, cone.top_radius);
    const Cuts cuts = cuts_of(cone, chord_error(center_of(cone), std::sqrt(half * half + radius * radius)), job_.subdivide);
    count(triangle_count(cone, cuts));
    Faces faces = cone_faces(cone, cuts);
    if (faces.count() == 0) ++geometry_.dropped_degenerate;
    faces.anchor = anchor_at(center_of(cone));
    cut_curved(std::move(faces));
}

void Tessellator::operator()(const Torus& torus) {
    const Cuts cuts = cuts_of(torus, chord_error(torus.center, torus.major + torus.minor), job_.subdivide);
    count(triangle_count(torus, cuts));
    Faces faces = torus_faces(torus, cuts);
    faces.anchor = anchor_at(torus.center);
    cut_curved(std::move(faces));
}

// A shape that is scaled unevenly may be so flat that its true normals turn away from its facets.
void Tessellator::cut_curved(Faces faces) {
    place(faces, job_.placement);
    auto of_faces = face_normals(faces);
    geometry_.dropped_degenerate += drop_degenerate(faces, of_faces);
    if (request_.normals && !job_.placement.similarity) face_outwards(faces, of_faces);
    emit(facets_of(faces, of_faces, request_.normals), faces.anchor, 1);
}

void Tessellator::cut_file_faces(FileFaces file) {
    Faces& faces = file.faces;
    auto of_faces = face_normals(faces);
    geometry_.dropped_degenerate += file.dropped + drop_degenerate(faces, of_faces);
    if (request_.normals) {
        const bool all_kept = std::all_of(faces.corners.begin(), faces.corners.end(), [](const Corner& c) { return c.normal != kNone; });
        if (!all_kept) smooth_normals(faces, of_faces, job_.object->crease);
        face_outwards(faces, of_faces, file.kept);
        if (!file.kept.empty() && !all_on_one_side(faces, of_faces)) geometry_.normals_may_vanish = true;
    }
    subdivide(faces, of_faces, job_.subdivide);
    emit(facets_of(faces, of_faces, request_.normals), faces.anchor + job_.placement.translation, 1);
}

void Tessellator::emit(const Facets& facets, const glm::dvec3& anchor, double scale) {
    Soup& soup = job_.two_sided ? two_sided_ : one_sided_;
    const auto vertex = static_cast<std::uint32_t>(geometry_.vertices.positions.size());
    for (const auto& t : facets.triangles) soup.triangles.push_back({vertex + t[0], vertex + t[1], vertex + t[2]});
    if (job_.two_sided) geometry_.faces_two_sided += facets.face_normals.size();
    if (request_.polygons) {
        const auto polygon = static_cast<std::uint32_t>(geometry_.polygons.positions.size());
        for (std::uint32_t face : facets.triangle_faces) soup.polygons.push_back(polygon + face);
        emit_polygons(facets, anchor, scale);
    }
    emit_vertices(facets, anchor, scale);
}

void Tessellator::emit_vertices(const Facets& facets, const glm::dvec3& anchor, double scale) {
    const double to_frame = geometry_.frame.scale;
    for (const auto& p : facets.positions) geometry_.vertices.positions.push_back({glm::vec3(to_frame * (anchor + scale * p)), 0});
    for (std::size_t i = 0; i < facets.normals.size(); ++i)
        geometry_.vertices.normals.push_back(
            {glm::vec3(facets.normals[i]), facets.vertex_materials.empty() ? job_.object->material : facets.vertex_materials[i]});
}

void Tessellator::emit_polygons(const Facets& facets, const glm::dvec3& anchor, double scale) {
    const double to_frame = geometry_.frame.scale;
    for (std::size_t f = 0; f < facets.face_normals.size(); ++f) {
        const auto number = static_cast<std::uint32_t>(geometry_.polygons.positions.size());
        geometry_.polygons.positions.push_back({glm::vec3(to_frame * (anchor + scale * facets.face_centers[f])), number});
        geometry_.polygons.normals.push_back(
            {glm::vec3(facets.face_normals[f]), facets.face_materials.empty() ? job_.object->material : facets.face_materials[f]});
        geometry_.polygon_objects.push_back(job_.number);
    }
}

RasterGeometry Tessellator::run() {
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
        const Object& object = scene_.objects[i];
        job_ = {&object, i, placement_of(scene_.transforms[object.transform]), 0, two_sided(object)};
        job_.placement.translation -= geometry_.frame.origin;
        job_.subdivide = std::min(request_.subdivide + object.subdivide, kMaxSubdivide);
        count_split(face_triangles(object.shape));
        std::visit(*this, object.shape);
    }
    order_triangles(geometry_, one_sided_, two_sided_);
    return std::move(geometry_);
}

} // namespace

RasterGeometry tessellate(const Scene& scene, const TessellationRequest& request) {
    return Tessellator(scene, request).run();
}

} // namespace lightbench
