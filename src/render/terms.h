// The layers of --terms: each is the image with a part of the effect mask, or another output of the same shaders.
#pragma once

#include <cstdint>
#include <string_view>

namespace lightbench {

struct Term {
    std::string_view name;
    std::uint32_t effects = 0; // bits of the mask that this layer keeps
    std::uint32_t output = 0;  // OUTPUT_...
    bool averaged = true;      // over samples and frames like the image: the light terms then add up to it
    bool background = false;   // the background is part of it
    std::uint32_t rays = 0;    // 1 << kRay...: of traced rays, what comes back by those that were sent on is part of it
};

// CHECKs that there is one of this name.
Term find_term(std::string_view name);

} // namespace lightbench
