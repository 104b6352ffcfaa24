// The ray tree of S13 to S19 once more: in double, by recursion, every object tested. Shares nothing with the device but the Scene.
#pragma once

#include "images/rendering.h"

namespace lightbench::testing {

// Spheres, planar polygons and boxes under any transform; Phong, opacity, mirrors, refraction with nested media, Fresnel's split.
// No textures, no bumps, no normals of a mesh.
struct Reference {
    const Scene& scene;
    unsigned depth = 5;
    bool shadows = true, clear_shadows = true;

    glm::dvec3 radiance(const glm::dvec3& origin, const glm::dvec3& direction) const;
};

Request ray_request(glm::uvec2 size = {48, 36}, unsigned depth = 5);

struct Agreement {
    unsigned sure = 0;   // pixels where a hundredth of a pixel hardly matters
    unsigned unsure = 0; // edges, and what mirrors and lenses enlarge
    unsigned differ = 0; // of the sure ones
    double worst = 0;    // of the sure ones, of the brightest pixel
    glm::uvec2 where{0};
};

// Sure pixels are those where moving the eye ray by 1/1000 of a pixel changes the reference by less than `still` of the brightest pixel;
// they differ if the device is off by more than `tolerance` of the brightest and by more than that change.
Agreement compare_to_reference(const Scene& scene, const Rendered& r, const Reference& reference, double tolerance = 1e-4,
                               double still = 1e-2);

} // namespace lightbench::testing
