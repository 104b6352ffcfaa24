// One object to be tessellated: how it stands, how finely it is cut, how many triangles that makes. Counting costs next to nothing, so a
// scene that is too big is refused before anything is allocated for it.
#pragma once

#include "scene/primitive_meshes.h"
#include "scene/tessellate.h"

namespace lightbench {

struct Job {
    const Scene* scene = nullptr;
    const Object* object = nullptr;
    std::uint32_t number = 0;
    Placement placement;        // translation relative to the frame's origin, metres
    glm::dvec3 eye{0};          // relative to the frame's origin, metres
    double error_per_metre = 0; // chord error allowed at a distance of 1 metre
    unsigned subdivide = 0;     // levels, of the request and the object together
    glm::dvec3 anchor_at(const glm::dvec3& center) const { return placement.translation + placement.linear * center; }
};

Job job_of(const Scene& scene, const TessellationRequest& request, const Frame& frame, std::uint32_t object);

Cuts cuts_of(const Job& job, const Sphere& sphere);
Cuts cuts_of(const Job& job, const Cone& cone);
Cuts cuts_of(const Job& job, const Torus& torus);

// No fewer than the object comes to.
std::size_t triangle_count(const Job& job);

} // namespace lightbench
