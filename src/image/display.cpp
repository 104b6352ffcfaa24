// The curve, the clamp and the rounding of display.h, pixel by pixel.
#include "image/display.h"

#include <cmath>

namespace lightbench {
namespace {

// The comparisons are false for NaN, which therefore ends as 0.
float clamp01(float x) {
    return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
}

std::uint8_t quantised(float x) {
    return static_cast<std::uint8_t>(std::lround(x * 255.0f));
}

} // namespace

// IEC 61966-2-1:1999, 5.2.
float srgb_from_linear(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

// IEC 61966-2-1:1999, 5.2, solved for the linear value.
float linear_from_srgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

Image8 display(const ImageF& radiance, float exposure) {
    Image8 picture{.width = radiance.width, .height = radiance.height, .rgba = {}};
    picture.rgba.resize(radiance.rgba.size());
    float gain = std::exp2(exposure);
    for (std::size_t i = 0; i < radiance.rgba.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) picture.rgba[i + c] = quantised(srgb_from_linear(clamp01(gain * radiance.rgba[i + c])));
        picture.rgba[i + 3] = quantised(clamp01(radiance.rgba[i + 3]));
    }
    return picture;
}

bool finite_color(const float* rgba) {
    return std::isfinite(rgba[0]) && std::isfinite(rgba[1]) && std::isfinite(rgba[2]);
}

std::size_t count_non_finite(const ImageF& image) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) count += !finite_color(&image.rgba[i]);
    return count;
}

} // namespace lightbench
