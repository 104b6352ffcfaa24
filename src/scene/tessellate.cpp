// Cuts every object into faces, normals, triangles and vertices, and fills the streams. In: Scene, request. Out: RasterGeometry.
#include "scene/tessellate.h"

#include "scene/limits.h"
#include "scene/normals.h"
#include "scene/subdivide.h"
#include "scene/surfaces.h"
#include "scene/tessellate_detail.h"
#include "scene/tessellate_facets.h"
#include "scene/tessellate_job.h"
#include "scene/tessellate_merge.h"
#include "scene/tessellate_provoke.h"
#include "scene/tessellate_sides.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <stdexcept>

namespace lightbench {
namespace {

// Meshes and polygons consist of faces; the other shapes have forms of their own to test rays against.
bool is_faceted(const Shape& shape) {
    return std::holds_alternative<MeshUse>(shape) || std::holds_alternative<Polygon>(shape);
}

class Tessellator {
  public:
    Tessellator(const Scene& scene, const TessellationRequest& request)
        : scene_(scene), request_(request), surfaces_(scene, request.cubes), meshes_(scene.meshes.size()) {
        geometry_.frame = frame_of(bounds_of(scene));
    }
    RasterGeometry run();

    // One a shape, for the object of job_.
    void operator()(const Sphere& sphere);
    void operator()(const Polygon& polygon) { cut_file_faces(polygon_faces(polygon, job_.placement, request_.normals)); }
    void operator()(const Box& box);
    void operator()(const Cylinder& cylinder) { (*this)(cone_of(cylinder)); }
    void operator()(const Cone& cone);
    void operator()(const Torus& torus) { cut_curved(torus_faces(torus, cuts_of(job_, torus)), torus.center); }
    void operator()(const MeshUse& use) {
        cut_file_faces(mesh_faces(scene_.meshes[use.mesh], *meshes_[use.mesh], job_.placement, request_.normals, request_.detail));
    }

  private:
    bool drawn(const Object& object) const { return !request_.analytic || is_faceted(object.shape); }
    void reserve();
    void start(std::uint32_t object);
    void cut_curved(Faces faces, const glm::dvec3& center);
    void cut_file_faces(FileFaces file);
    void emit(const Facets& facets, const glm::dvec3& anchor, double scale);
    void emit_triangles(const Facets& facets);
    std::size_t soup_of_material(std::uint32_t material) const;
    std::uint32_t surface(std::uint32_t material) { return surfaces_.number(material, job_.number); }
    gpu_layout::PointDetail in_frame(const Detail& detail) const;
    void emit_vertices(const Facets& facets, const glm::dvec3& anchor, double scale);
    void emit_polygons(const Facets& facets, const glm::dvec3& anchor, double scale);

    const Scene& scene_;
    const TessellationRequest& request_;
    RasterGeometry geometry_;
    SurfaceTable surfaces_;
    Soups soups_;
    Job job_;
    bool job_two_sided_ = false;
    std::vector<std::optional<WeldedMesh>> meshes_; // those that an object used so far
    std::map<Cuts, Facets> spheres_;                // of radius 1
};

// Where all directions are scaled alike a sphere stays one, however it is turned: spheres of the same fineness share their facets.
void Tessellator::operator()(const Sphere& sphere) {
    const Cuts cuts = cuts_of(job_, sphere);
    if (!job_.placement.similarity) {
        Faces faces = unit_sphere_faces(cuts);
        for (auto& p : faces.points) p *= sphere.radius;
        return cut_curved(std::move(faces), sphere.center);
    }
    auto& known = spheres_[cuts];
    if (known.triangles.empty()) {
        const Faces faces = unit_sphere_faces(cuts);
        known = facets_of(faces, face_normals(faces), request_.normals);
    }
    emit(known, job_.anchor_at(sphere.center), *job_.placement.similarity * sphere.radius);
}

void Tessellator::operator()(const Box& box) {
    FileFaces made;
    made.faces = box_faces(box);
    place(made.faces, job_.placement);
    made.faces.anchor = job_.placement.linear * center_of(box);
    cut_file_faces(std::move(made));
}

void Tessellator::operator()(const Cone& cone) {
    Faces faces = cone_faces(cone, cuts_of(job_, cone));
    if (faces.count() == 0) ++geometry_.dropped_degenerate;
    cut_curved(std::move(faces), center_of(cone));
}

// A shape that is scaled unevenly may be so flat that its true normals turn away from its facets.
void Tessellator::cut_curved(Faces faces, const glm::dvec3& center) {
    place(faces, job_.placement);
    auto of_faces = face_normals(faces);
    geometry_.dropped_degenerate += drop_degenerate(faces, of_faces);
    if (request_.normals && !job_.placement.similarity) face_outwards(faces, of_faces);
    emit(facets_of(faces, of_faces, request_.normals), job_.anchor_at(center), 1);
}

void Tessellator::cut_file_faces(FileFaces file) {
    Faces& faces = file.faces;
    auto of_faces = face_normals(faces);
    geometry_.dropped_degenerate += file.dropped + drop_degenerate(faces, of_faces);
    if (request_.normals) {
        const bool all_given = std::none_of(faces.corners.begin(), faces.corners.end(), [](const Corner& c) { return c.normal == kNone; });
        if (!all_given) smooth_normals(faces, of_faces, job_.object->crease);
        face_outwards(faces, of_faces, file.kept);
        if (!file.kept.empty() && !all_on_one_side(faces, of_faces)) geometry_.normals_may_vanish = true;
    }
    subdivide(faces, of_faces, job_.subdivide);
    std::optional<Details> details;
    if (!faces.corner_textures.empty()) details = details_of(faces, of_faces, request_.normals);
    emit(facets_of(faces, of_faces, request_.normals, details ? &*details : nullptr), job_.placement.translation + faces.anchor, 1);
}

std::size_t Tessellator::soup_of_material(std::uint32_t material) const {
    const Material& m = scene_.materials[material];
    return is_translucent(m) ? soup_of(true, is_two_sided(m)) : soup_of(false, job_two_sided_);
}

void Tessellator::emit_triangles(const Facets& facets) {
    const auto vertex = static_cast<std::uint32_t>(geometry_.vertices.positions.size());
    const auto polygon = static_cast<std::uint32_t>(geometry_.polygons.positions.size());
    std::vector<std::size_t> soup_of_face;
    for (std::uint32_t m : facets.face_materials) soup_of_face.push_back(soup_of_material(m));
    const std::size_t common = soup_of_material(job_.object->material), faces = facets.face_normals.size();
    for (std::size_t f = 0; f < faces; ++f)
        if ((soup_of_face.empty() ? common : soup_of_face[f]) % 2 == 1) ++geometry_.faces_two_sided;
    for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
        const auto& t = facets.triangles[i];
        Soup& soup = soups_[soup_of_face.empty() ? common : soup_of_face[facets.triangle_faces[i]]];
        soup.triangles.push_back({vertex + t[0], vertex + t[1], vertex + t[2]});
        if (request_.polygons) soup.polygons.push_back(polygon + facets.triangle_faces[i]);
    }
}

void Tessellator::emit(const Facets& facets, const glm::dvec3& anchor, double scale) {
    if (facets.face_normals.empty()) return;
    emit_triangles(facets);
    if (request_.polygons) emit_polygons(facets, anchor, scale);
    emit_vertices(facets, anchor, scale);
}

// Gradients per metre of an object that stands in the world, per frame unit here.
gpu_layout::PointDetail Tessellator::in_frame(const Detail& detail) const {
    const double per_unit = 1 / geometry_.frame.scale;
    return {detail.uv, 0, 0, per_unit * detail.u_gradient, 0, per_unit * detail.v_gradient, 0};
}

void Tessellator::emit_vertices(const Facets& facets, const glm::dvec3& anchor, double scale) {
    const double to_frame = geometry_.frame.scale;
    for (const auto& p : facets.positions) geometry_.vertices.positions.push_back({glm::vec3(to_frame * (anchor + scale * p)), 0});
    for (std::size_t i = 0; i < facets.normals.size(); ++i)
        geometry_.vertices.normals.push_back(
            {glm::vec3(facets.normals[i]), surface(facets.vertex_materials.empty() ? job_.object->material : facets.vertex_materials[i])});
    if (!request_.detail) return;
    for (const Detail& d : facets.details) geometry_.vertices.detail.push_back(in_frame(d));
    geometry_.vertices.detail.resize(geometry_.vertices.normals.size());
}

void Tessellator::emit_polygons(const Facets& facets, const glm::dvec3& anchor, double scale) {
    const double to_frame = geometry_.frame.scale;
    for (std::size_t f = 0; f < facets.face_normals.size(); ++f) {
        const auto number = static_cast<std::uint32_t>(geometry_.polygons.positions.size());
        geometry_.polygons.positions.push_back({glm::vec3(to_frame * (anchor + scale * facets.face_centers[f])), number});
        geometry_.polygons.normals.push_back(
            {glm::vec3(facets.face_normals[f]), surface(facets.face_materials.empty() ? job_.object->material : facets.face_materials[f])});
        geometry_.polygon_objects.push_back(job_.number);
    }
    if (!request_.detail) return;
    for (const Detail& d : facets.face_details) geometry_.polygons.detail.push_back(in_frame(d));
    geometry_.polygons.detail.resize(geometry_.polygons.positions.size());
}

// Room for everything at once: growing step by step would need twice the memory at the end. What is not filled is never touched.
void Tessellator::reserve() {
    std::size_t triangles = 0;
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
        if (!drawn(scene_.objects[i])) continue;
        triangles += triangle_count(job_of(scene_, request_, geometry_.frame, i));
        if (triangles > limits::kMaxTriangles)
            throw std::length_error(
                fmt::format("object {} of {} brings the scene to {} triangles; kMaxTriangles is {}: subdivide less, or draw less", i + 1,
                            scene_.objects.size(), triangles, limits::kMaxTriangles));
    }
    geometry_.vertices.positions.reserve(triangles);
    if (request_.normals) geometry_.vertices.normals.reserve(triangles);
    if (request_.normals && request_.detail) geometry_.vertices.detail.reserve(triangles);
    soups_[0].triangles.reserve(triangles);
    if (!request_.polygons) return;
    soups_[0].polygons.reserve(triangles);
    if (request_.detail) geometry_.polygons.detail.reserve(triangles);
    geometry_.polygons.positions.reserve(triangles);
    geometry_.polygons.normals.reserve(triangles);
    geometry_.polygon_objects.reserve(triangles);
}

void Tessellator::start(std::uint32_t number) {
    job_ = job_of(scene_, request_, geometry_.frame, number);
    const auto* use = std::get_if<MeshUse>(&job_.object->shape);
    if (use && !meshes_[use->mesh]) meshes_[use->mesh] = weld(scene_.meshes[use->mesh]);
    job_two_sided_ = is_two_sided(scene_, *job_.object, use ? &*meshes_[use->mesh] : nullptr);
}

RasterGeometry Tessellator::run() {
    reserve();
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
        start(i);
        if (drawn(*job_.object)) std::visit(*this, job_.object->shape);
        if (request_.analytic) geometry_.object_surfaces.push_back(surface(job_.object->material));
    }
    const auto polygons = std::count_if(scene_.objects.begin(), scene_.objects.end(),
                                        [](const Object& object) { return std::holds_alternative<Polygon>(object.shape); });
    if (polygons > 1) merge_vertices(geometry_, soups_);
    order_triangles(geometry_, soups_);
    geometry_.surfaces = surfaces_.take();
    return std::move(geometry_);
}

} // namespace

RasterGeometry tessellate(const Scene& scene, const TessellationRequest& request) {
    return Tessellator(scene, request).run();
}

} // namespace lightbench
