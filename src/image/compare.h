// Two pictures compared in every way that `lightbench compare` and the image tests report.
#pragma once

#include "image/files.h"
#include "image/flip.h"
#include "image/metrics.h"

#include <string_view>

namespace lightbench {

struct Comparison {
    std::string_view space; // of the metrics: "linear" when both pictures are, else "display"
    Metrics metrics;
    FlipMap flip_map; // a pixel that is not finite in either picture counts as 1
    double flip_mean = 0;
};

// Linear pictures are displayed (exposure 0, clamp, sRGB) for FLIP, and for the metrics too when the other one is not linear.
// Throws std::invalid_argument when the sizes differ.
Comparison compare(const AnyImage& reference, const AnyImage& test);

// FLIP as a picture: from black (none) over blue, green and pink to white (1), ever lighter.
Image8 difference_picture(const FlipMap& map);

} // namespace lightbench
