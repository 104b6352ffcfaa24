// LDR-FLIP: the difference that a person sees when two pictures alternate on a screen.
// Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference Evaluator for Alternating Images".
#pragma once

#include "image/image.h"

#include <vector>

namespace lightbench {

// The paper's viewer: 0.7 m from a screen 0.7 m and 3840 pixels wide sees 3840 * pi / 180 = 67 pixels in a degree.
constexpr float kPixelsPerDegree = 67.020643f;

struct FlipMap {
    unsigned width = 0, height = 0;
    std::vector<float> error; // 0 (no difference seen) to 1, row by row
};

// Throws std::invalid_argument when the sizes differ. Agrees with the authors' own evaluator to 1e-3 a pixel (test Flip.Evaluator).
FlipMap flip(const Image8& reference, const Image8& test, float pixels_per_degree = kPixelsPerDegree);

double mean(const FlipMap& map);
double percentile(const FlipMap& map, double fraction); // the error that `fraction` of the pixels do not exceed

} // namespace lightbench
