// One pixel explained: its ray tree as the device traced it, and the illumination equation at every hit once more in double on the host.
// In: scene, tessellation, plan, view, a pixel. Out: rays with hits, terms, and the reason why each branch ended.
#pragma once

#include "plan/complete.h"
#include "render/render.h"

#include <optional>
#include <string>
#include <vector>

namespace lightbench {

// The terms of one light (S2 to S6, S15). World space, metres.
struct ProbedLight {
    LightType type = LightType::point;
    glm::dvec3 l{0}, r{0};              // unit: to the light; its mirror direction about the normal
    double nl = 0, rv = 0;              // N.L, R.V
    double distance = 0;                // 0: a directional light
    double attenuation = 1, spot = 1;   // factors
    glm::dvec3 intensity{0}, shadow{1}; // Ip; what of it arrives, by the device's shadow ray
    glm::dvec3 diffuse{0}, specular{0}; // radiance, with all factors
};

struct ProbedHit {
    std::uint32_t object = 0, material = 0; // of the scene
    double distance = 0;                    // from the ray's origin
    glm::dvec3 position{0}, normal{0}, face{0}, viewer{0};
    glm::dvec3 kd{0}, opacity{1}; // as textures have them
    glm::dvec3 emission{0}, ambient{0};
    std::vector<ProbedLight> lights;
    glm::dvec3 sum{0};    // opacity times all terms, in double
    glm::dvec3 device{0}; // the same by the device
};

struct ProbedStop {
    std::string branch; // "reflected", "refracted", "straight"
    std::string reason;
};

struct ProbedRay {
    std::string kind; // "eye", "reflected", "refracted", "straight"
    unsigned level = 1;
    glm::dvec3 weight{1}; // in the sum of its parent
    glm::dvec3 origin{0}, direction{0};
    glm::dvec3 radiance{0};            // that comes along it, children included
    std::optional<ProbedHit> hit;      // none: it leaves the scene
    std::vector<ProbedStop> stops;     // branches that were not followed
    std::vector<std::size_t> children; // index into Probe::rays
};

struct Probe {
    std::vector<ProbedRay> rays; // the eye ray first
};

// Through the middle of the pixel. The plan is that of a ray tracer.
Probe probe_pixel(gpu::Device& device, const Scene& scene, const RasterGeometry& geometry, const Plan& plan, const View& view,
                  glm::uvec2 pixel);

} // namespace lightbench
