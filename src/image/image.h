// Pictures in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lightbench {

// Linear radiance, RGBA, row by row from the upper left.
struct ImageF {
    unsigned width = 0, height = 0;
    std::vector<float> rgba;
    float* at(unsigned x, unsigned y) { return &rgba[(std::size_t{y} * width + x) * 4]; }
    const float* at(unsigned x, unsigned y) const { return &rgba[(std::size_t{y} * width + x) * 4]; }
};

// Display-referred, 8 bits, sRGB encoded, RGBA, row by row from the upper left.
struct Image8 {
    unsigned width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    std::uint8_t* at(unsigned x, unsigned y) { return &rgba[(std::size_t{y} * width + x) * 4]; }
    const std::uint8_t* at(unsigned x, unsigned y) const { return &rgba[(std::size_t{y} * width + x) * 4]; }
};

} // namespace lightbench
