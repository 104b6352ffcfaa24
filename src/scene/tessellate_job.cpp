// Fineness and triangle counts of objects. In: Scene, request, frame. Out: Job, Cuts, counts.
#include "scene/tessellate_job.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

constexpr unsigned kMaxSubdivide = 8;

// An eye nearer to the sphere about a shape than this part of its radius, or inside, is taken to be as near as this: what it sees of the
// shape's outline is farther than the nearest point, for the horizon of a sphere of radius r seen from a height h is sqrt(2 r h) away.
constexpr double kNearestPart = 1.0 / 16;

// The chord error allowed, in object units, for a shape within `radius` of `center`.
double chord_error(const Job& job, const glm::dvec3& center, double radius) {
    const double world_radius = job.placement.stretch * radius;
    const double nearest = glm::length(job.anchor_at(center) - job.eye) - world_radius;
    const double error = job.error_per_metre * std::max(nearest, kNearestPart * world_radius);
    return job.placement.stretch > 0 ? error / job.placement.stretch : radius;
}

// Triangles of a face of n corners; every level of subdivision makes 4 of each, or fewer.
std::size_t face_triangles(std::size_t corners) {
    return std::max<std::size_t>(corners, 3) - 2;
}

struct Counter {
    const Job& job;
    std::size_t split(std::size_t triangles) const { return triangles << (2 * job.subdivide); }
    std::size_t operator()(const Sphere& sphere) const { return triangle_count(sphere, cuts_of(job, sphere)); }
    std::size_t operator()(const Cone& cone) const { return triangle_count(cone, cuts_of(job, cone)); }
    std::size_t operator()(const Cylinder& cylinder) const { return (*this)(cone_of(cylinder)); }
    std::size_t operator()(const Torus& torus) const { return triangle_count(torus, cuts_of(job, torus)); }
    std::size_t operator()(const Box&) const { return split(12); }
    std::size_t operator()(const Polygon& polygon) const { return split(face_triangles(polygon.points.size())); }
    std::size_t operator()(const MeshUse& use) const {
        const Mesh& mesh = job.scene->meshes[use.mesh];
        std::size_t triangles = 0;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) triangles += face_triangles(mesh.face_starts[f + 1] - mesh.face_starts[f]);
        return split(triangles);
    }
};

} // namespace

Job job_of(const Scene& scene, const TessellationRequest& request, const Frame& frame, std::uint32_t number) {
    const Object& object = scene.objects[number];
    Job job{&scene, &object, number, placement_of(scene.transforms[object.transform])};
    job.placement.translation -= frame.origin;
    job.eye = request.eye - frame.origin;
    job.error_per_metre = request.pixels * request.pixel_angle;
    job.subdivide = std::min(request.subdivide + object.subdivide, kMaxSubdivide);
    return job;
}

Cuts cuts_of(const Job& job, const Sphere& sphere) {
    return cuts_of(sphere, chord_error(job, sphere.center, sphere.radius), job.subdivide);
}

Cuts cuts_of(const Job& job, const Cone& cone) {
    const double half = 0.5 * glm::length(cone.top - cone.base), radius = std::max(cone.base_radius, cone.top_radius);
    return cuts_of(cone, chord_error(job, center_of(cone), std::sqrt(half * half + radius * radius)), job.subdivide);
}

Cuts cuts_of(const Job& job, const Torus& torus) {
    return cuts_of(torus, chord_error(job, torus.center, torus.major + torus.minor), job.subdivide);
}

std::size_t triangle_count(const Job& job) {
    return std::visit(Counter{job}, job.object->shape);
}

} // namespace lightbench
