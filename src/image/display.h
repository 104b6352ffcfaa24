// From linear radiance to a picture for a screen: exposure, clamp, sRGB. The reference that the display shader is tested against.
#pragma once

#include "image/image.h"

#include <cstddef>

namespace lightbench {

// IEC 61966-2-1:1999, sRGB; both on [0, 1], inverse of each other to 1e-7. NaN and values outside must have been dealt with.
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);

// 2^exposure times the radiance, clamped to [0, 1] (NaN becomes 0: count with count_non_finite first), encoded, rounded to the
// nearest of 256 steps. Alpha is clamped and rounded, never encoded.
Image8 display(const ImageF& radiance, float exposure = 0.0f);

bool finite_color(const float* rgba); // red, green and blue are neither NaN nor infinite

// Pixels with a NaN or an infinity in red, green or blue.
std::size_t count_non_finite(const ImageF& image);

} // namespace lightbench
