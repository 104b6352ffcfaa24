// The illumination equation of one hit in double. In: scene, material, point. Out: each light's terms.
#pragma once

#include "render/probe.h"

namespace lightbench {

// Everything of `light` but its shadow, at a hit whose position, normal, viewer and kd are known.
ProbedLight probe_light(const Light& light, const Material& material, const ProbedHit& hit);

// S6's Fresnel term: reflectance at a cosine, per channel; 1 beyond the critical angle.
glm::dvec3 probe_fresnel(double cosine, const glm::dvec3& eta);

} // namespace lightbench
