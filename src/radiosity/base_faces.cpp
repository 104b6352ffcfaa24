// Objects as faces, by the same shapes that tessellation uses; welding. What the header of the same name says.
#include "radiosity/base_faces.h"

#include "scene/limits.h"
#include "scene/normals.h"
#include "scene/surfaces.h"
#include "scene/tessellate_job.h"
#include "scene/tessellate_sides.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <meshoptimizer.h>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace lightbench {
namespace {

// A circle of fewer pieces is no circle.
constexpr double kMinAround = 8;

class BaseMaker {
  public:
    BaseMaker(const Scene& scene, const Frame& frame, double facet)
        : scene_(scene), facet_(facet / frame.scale), surfaces_(scene, {}), meshes_(scene.meshes.size()) {
        base_.frame = frame;
    }
    BaseMesh run();

    // One a shape, for the object of job_.
    void operator()(const Sphere& sphere);
    void operator()(const Polygon& polygon) { add_file_faces(polygon_faces(polygon, job_.placement, true)); }
    void operator()(const Box& box);
    void operator()(const Cylinder& cylinder) { (*this)(cone_of(cylinder)); }
    void operator()(const Cone& cone);
    void operator()(const Torus& torus);
    void operator()(const MeshUse& use) { add_file_faces(mesh_faces(scene_.meshes[use.mesh], *meshes_[use.mesh], job_.placement, true)); }

  private:
    double pieces(double length) const { return pieces_of(job_.placement.stretch * length, facet_); }
    std::uint32_t around(double radius) const {
        return static_cast<std::uint32_t>(std::min(std::max(kMinAround, pieces(2 * std::numbers::pi * radius)), 1e9));
    }
    void expect_few(double faces);
    void start(std::uint32_t object);
    void add_curved(Faces faces, const glm::dvec3& center);
    void add_file_faces(FileFaces file);
    void add(const Faces& faces, const std::vector<glm::dvec3>& of_faces, const glm::dvec3& anchor);
    bool two_sided(std::uint32_t material) const;
    void weld_points();
    void drop_collapsed();

    const Scene& scene_;
    const double facet_; // metres
    BaseMesh base_;
    SurfaceTable surfaces_;
    Job job_;
    bool job_two_sided_ = false;
    double curved_faces_ = 0;
    std::vector<std::optional<WeldedMesh>> meshes_;
};

void BaseMaker::expect_few(double faces) {
    curved_faces_ += faces;
    if (curved_faces_ > double(limits::kMaxElements))
        throw std::length_error(
            fmt::format("object {} brings the scene to {:.0f} elements; kMaxElements is {}: ask for larger ones, or draw less",
                        job_.number + 1, curved_faces_, limits::kMaxElements));
}

// An edge of the icosahedron is 1.0515 radii long; blown up to the sphere the longest piece of it is 1 / 0.79465 of that over the pieces.
void BaseMaker::operator()(const Sphere& sphere) {
    constexpr double kLongest = 1.0514622242382672 / 0.7946544722917661;
    const double along = std::max(1.0, pieces(kLongest * sphere.radius));
    expect_few(20 * along * along);
    Faces faces = unit_sphere_faces({static_cast<std::uint32_t>(along), 20});
    for (auto& p : faces.points) p *= sphere.radius;
    add_curved(std::move(faces), sphere.center);
}

void BaseMaker::operator()(const Box& box) {
    Faces faces = box_faces(box);
    place(faces, job_.placement);
    auto of_faces = face_normals(faces);
    base_.dropped += drop_degenerate(faces, of_faces);
    add(faces, of_faces, job_.anchor_at(center_of(box)));
}

void BaseMaker::operator()(const Cone& cone) {
    const std::uint32_t along = around(std::max(cone.base_radius, cone.top_radius));
    expect_few(along);
    Faces faces = cone_faces(cone, {along, 1});
    if (faces.count() == 0) ++base_.dropped;
    add_curved(std::move(faces), center_of(cone));
}

void BaseMaker::operator()(const Torus& torus) {
    const Cuts cuts{around(torus.major + torus.minor), around(torus.minor)};
    expect_few(double(cuts.along) * cuts.across);
    add_curved(torus_faces(torus, cuts), torus.center);
}

void BaseMaker::add_curved(Faces faces, const glm::dvec3& center) {
    place(faces, job_.placement);
    auto of_faces = face_normals(faces);
    base_.dropped += drop_degenerate(faces, of_faces);
    add(faces, of_faces, job_.anchor_at(center));
}

void BaseMaker::add_file_faces(FileFaces file) {
    auto of_faces = face_normals(file.faces);
    base_.dropped += file.dropped + drop_degenerate(file.faces, of_faces);
    smooth_normals(file.faces, of_faces, job_.object->crease);
    add(file.faces, of_faces, job_.placement.translation + file.faces.anchor);
}

// As the rasteriser culls.
bool BaseMaker::two_sided(std::uint32_t material) const {
    const Material& m = scene_.materials[material];
    return is_translucent(m) ? is_two_sided(m) : job_two_sided_;
}

void BaseMaker::add(const Faces& faces, const std::vector<glm::dvec3>& of_faces, const glm::dvec3& anchor) {
    const auto point = static_cast<std::uint32_t>(base_.points.size()), normal = static_cast<std::uint32_t>(base_.normals.size());
    for (const auto& p : faces.points) base_.points.push_back(base_.frame.scale * (anchor + p) + 0.0); // + 0: no -0, whose bits differ
    base_.normals.insert(base_.normals.end(), faces.normals.begin(), faces.normals.end());
    for (std::size_t f = 0; f < faces.count(); ++f) {
        const auto loop = faces.loop(f);
        const std::uint32_t material = faces.materials.empty() ? job_.object->material : faces.materials[f];
        const std::uint32_t hub = faces.hubs.empty() || faces.hubs[f].point == kNone ? kNone : point + faces.hubs[f].point;
        base_.faces.push_back({static_cast<std::uint32_t>(base_.corners.size()), static_cast<std::uint32_t>(loop.size()),
                               surfaces_.number(material, job_.number), job_.number, hub, job_.object->crease, two_sided(material),
                               of_faces[f]});
        for (const Corner& c : loop) base_.corners.push_back({point + c.point, normal + c.normal});
    }
}

// Keeps the order in which points were first used.
void BaseMaker::weld_points() {
    if (base_.points.empty()) return;
    const std::size_t all = base_.points.size();
    std::vector<std::uint32_t> to(all);
    const std::size_t kept = meshopt_generateVertexRemap(to.data(), nullptr, all, base_.points.data(), all, sizeof(glm::dvec3));
    std::vector<glm::dvec3> points(kept);
    for (std::size_t i = 0; i < all; ++i) points[to[i]] = base_.points[i];
    base_.points = std::move(points);
    for (Corner& c : base_.corners) c.point = to[c.point];
    for (BaseFace& f : base_.faces)
        if (f.hub != kNone) f.hub = to[f.hub];
}

// What is told apart in its object's own axes may fall together in the frame: faces that are left without three corners are no faces.
void BaseMaker::drop_collapsed() {
    std::size_t kept = 0;
    std::uint32_t corners = 0;
    for (BaseFace face : base_.faces) {
        const std::uint32_t first = corners, end = face.first + face.count;
        for (std::uint32_t i = face.first; i < end; ++i)
            if (corners == first || base_.corners[corners - 1].point != base_.corners[i].point) base_.corners[corners++] = base_.corners[i];
        while (corners > first + 1 && base_.corners[corners - 1].point == base_.corners[first].point) --corners;
        face.first = first, face.count = corners - first;
        if (face.count < 3)
            corners = first, ++base_.dropped;
        else
            base_.faces[kept++] = face;
    }
    base_.faces.resize(kept);
    base_.corners.resize(corners);
}

void BaseMaker::start(std::uint32_t number) {
    job_ = job_of(scene_, {}, base_.frame, number);
    const auto* use = std::get_if<MeshUse>(&job_.object->shape);
    if (use && !meshes_[use->mesh]) meshes_[use->mesh] = weld(scene_.meshes[use->mesh]);
    job_two_sided_ = is_two_sided(scene_, *job_.object, use ? &*meshes_[use->mesh] : nullptr);
}

BaseMesh BaseMaker::run() {
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
        start(i);
        std::visit(*this, job_.object->shape);
    }
    weld_points();
    drop_collapsed();
    base_.surfaces = surfaces_.take();
    return std::move(base_);
}

} // namespace

double pieces_of(double length, double most) {
    return std::max(1.0, std::ceil(length / most * (1 - 0x1p-40)));
}

BaseMesh base_faces(const Scene& scene, const Frame& frame, double facet) {
    return BaseMaker(scene, frame, facet).run();
}

} // namespace lightbench
