// How far two pictures of one size lie apart, channel by channel. Red, green and blue count; alpha does not.
#pragma once

#include "image/image.h"

#include <cstddef>

namespace lightbench {

// For ImageF in linear light; for Image8 on display values, v / 255.
struct Metrics {
    double rmse = 0;                      // over all channels
    double psnr = 0;                      // dB, peak 1 (white at exposure 0); infinite for equal pictures
    double max = 0;                       // largest difference of a channel
    std::size_t differing = 0;            // pixels with any difference, or not finite in one of the two
    std::size_t non_finite_reference = 0; // pixels with NaN or infinity
    std::size_t non_finite_test = 0;
};

// No figure of the other pixels would be honest: with a pixel that is not finite rmse and max are infinite, psnr is minus infinity.
void spoil_if_non_finite(Metrics& metrics);

// Throws std::invalid_argument when the sizes differ.
Metrics metrics(const ImageF& reference, const ImageF& test);
Metrics metrics(const Image8& reference, const Image8& test);

// Throws the std::invalid_argument that every comparison throws for two sizes.
void check_same_size(unsigned width_a, unsigned height_a, unsigned width_b, unsigned height_b);

} // namespace lightbench
