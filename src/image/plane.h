// One channel of a picture in floats, and separable filters on it; the border pixels go on beyond the border. Private to image/.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lightbench {

struct Plane {
    unsigned width = 0, height = 0;
    std::vector<float> values;
    Plane() = default;
    Plane(unsigned w, unsigned h) : width(w), height(h), values(std::size_t{w} * h) {}
    float* row(unsigned y) { return &values[std::size_t{y} * width]; }
    const float* row(unsigned y) const { return &values[std::size_t{y} * width]; }
};

// Correlation with an odd number of taps, the middle one on the pixel.
Plane filtered_rows(const Plane& in, std::span<const float> taps);
Plane filtered_columns(const Plane& in, std::span<const float> taps);

} // namespace lightbench
