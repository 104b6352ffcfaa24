// One loop over the pixels for both kinds of picture; sums in double.
#include "image/metrics.h"
#include "image/display.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace lightbench {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

bool finite(const float* p) {
    return finite_color(p);
}
bool finite(const std::uint8_t*) {
    return true;
}
double value(float v) {
    return v;
}
double value(std::uint8_t v) {
    return v / 255.0;
}

template <class Image> Metrics measure(const Image& reference, const Image& test) {
    check_same_size(reference.width, reference.height, test.width, test.height);
    Metrics result;
    double squares = 0;
    for (std::size_t i = 0; i < reference.rgba.size(); i += 4) {
        const auto *a = &reference.rgba[i], *b = &test.rgba[i];
        result.non_finite_reference += !finite(a);
        result.non_finite_test += !finite(b);
        if (!finite(a) || !finite(b)) {
            ++result.differing;
            continue;
        }
        double largest = 0;
        for (int c = 0; c < 3; ++c) {
            double d = std::abs(value(b[c]) - value(a[c]));
            squares += d * d;
            largest = std::max(largest, d);
        }
        result.max = std::max(result.max, largest);
        result.differing += largest > 0;
    }
    result.rmse = reference.rgba.empty() ? 0.0 : std::sqrt(squares / (0.75 * static_cast<double>(reference.rgba.size())));
    result.psnr = result.rmse == 0 ? kInfinite : -20.0 * std::log10(result.rmse);
    spoil_if_non_finite(result);
    return result;
}

} // namespace

void spoil_if_non_finite(Metrics& metrics) {
    if (metrics.non_finite_reference + metrics.non_finite_test == 0) return;
    metrics.rmse = metrics.max = kInfinite, metrics.psnr = -kInfinite;
}

void check_same_size(unsigned width_a, unsigned height_a, unsigned width_b, unsigned height_b) {
    if (width_a == width_b && height_a == height_b) return;
    throw std::invalid_argument(
        fmt::format("the sizes differ: the reference has {} x {} pixels, the other {} x {}", width_a, height_a, width_b, height_b));
}

Metrics metrics(const ImageF& reference, const ImageF& test) {
    return measure(reference, test);
}

Metrics metrics(const Image8& reference, const Image8& test) {
    return measure(reference, test);
}

} // namespace lightbench
