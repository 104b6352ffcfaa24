// What tests of the ray tracer's samples ask for.
#pragma once

#include "images/rendering.h"

namespace lightbench::testing {

inline constexpr glm::uvec2 kSize{48, 40};

inline Request traced(Sampling sampling, Filter filter = Filter::box, unsigned spp = 1) {
    Request request = radiance_request(Shading::phong, kSize);
    request.method = Method::raytrace, request.sampling = sampling, request.filter = filter, request.spp = spp;
    request.count = true;
    return request;
}

inline Request adaptive(unsigned max_level) {
    Request request = traced(Sampling::adaptive);
    request.max_level = max_level;
    return request;
}

} // namespace lightbench::testing
