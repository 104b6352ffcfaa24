// Brings two pictures into one space, measures, and colours the difference.
#include "image/compare.h"
#include "image/display.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lightbench {
namespace {

Image8 displayed(const AnyImage& picture) {
    if (const auto* linear = std::get_if<ImageF>(&picture)) return display(*linear);
    return std::get<Image8>(picture);
}

// NaN is displayed as black: without this, a hole in the picture would pass a gate on FLIP wherever the reference is dark.
void mark_non_finite(FlipMap& map, const AnyImage& picture) {
    const auto* linear = std::get_if<ImageF>(&picture);
    if (!linear) return;
    for (std::size_t i = 0; i < map.error.size(); ++i) {
        if (!finite_color(&linear->rgba[i * 4])) map.error[i] = 1.0f;
    }
}

// Of a linear picture beside a displayed one: what is not finite is displayed as black, which the other may hold too.
void add_non_finite(Metrics& m, const AnyImage& reference, const AnyImage& test, const Image8& shown_reference, const Image8& shown_test) {
    const auto *a = std::get_if<ImageF>(&reference), *b = std::get_if<ImageF>(&test);
    for (std::size_t i = 0; i < shown_reference.rgba.size(); i += 4) {
        const bool lost_a = a && !finite_color(&a->rgba[i]), lost_b = b && !finite_color(&b->rgba[i]);
        const bool equal = std::equal(&shown_reference.rgba[i], &shown_reference.rgba[i] + 3, &shown_test.rgba[i]);
        m.non_finite_reference += lost_a, m.non_finite_test += lost_b;
        m.differing += (lost_a || lost_b) && equal;
    }
    spoil_if_non_finite(m);
}

// Green 2011, "A colour scheme for the display of astronomical intensity images", eq. 2: perceived brightness rises with `t` while the
// hue turns; start 0.5, 1.5 turns backwards, saturation 1, gamma 1.
std::array<std::uint8_t, 3> cubehelix(double t) {
    double angle = 2 * std::numbers::pi * (0.5 / 3 + 1 - 1.5 * t);
    double amplitude = t * (1 - t) / 2, c = std::cos(angle), s = std::sin(angle);
    auto step = [](double v) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0))); };
    return {step(t + amplitude * (-0.14861 * c + 1.78277 * s)), step(t + amplitude * (-0.29227 * c - 0.90649 * s)),
            step(t + amplitude * 1.97294 * c)};
}

} // namespace

Comparison compare(const AnyImage& reference, const AnyImage& test) {
    Image8 shown_reference = displayed(reference), shown_test = displayed(test);
    const auto *a = std::get_if<ImageF>(&reference), *b = std::get_if<ImageF>(&test);
    Comparison result;
    result.space = a && b ? "linear" : "display";
    result.metrics = a && b ? metrics(*a, *b) : metrics(shown_reference, shown_test);
    if (!(a && b)) add_non_finite(result.metrics, reference, test, shown_reference, shown_test);
    result.flip_map = flip(shown_reference, shown_test);
    mark_non_finite(result.flip_map, reference);
    mark_non_finite(result.flip_map, test);
    result.flip_mean = mean(result.flip_map);
    return result;
}

Image8 difference_picture(const FlipMap& map) {
    Image8 picture{.width = map.width, .height = map.height, .rgba = {}};
    picture.rgba.reserve(map.error.size() * 4);
    for (float e : map.error) {
        auto color = cubehelix(static_cast<double>(e));
        picture.rgba.insert(picture.rgba.end(), {color[0], color[1], color[2], 255});
    }
    return picture;
}

} // namespace lightbench
