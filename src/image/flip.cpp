// The steps of the paper: what the eye resolves of colour (4.1), how different that is (4.1), where edges and points differ (4.2), and
// both together (4.3). Numbers are the paper's sections; its filters are separable and evaluated so.
#include "image/flip.h"
#include "image/color_spaces.h"
#include "image/display.h"
#include "image/metrics.h"
#include "image/plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lightbench {
namespace {

using color::Triple;

constexpr float kColorExponent = 0.7f;   // q_c, 4.1.3: large colour differences are compressed
constexpr float kFeatureExponent = 0.5f; // q_f, 4.2
constexpr float kCut = 0.4f;             // p_c and p_t, 4.1.3: differences below 0.4 of the largest
constexpr float kCutTarget = 0.95f;      // possible one take the range up to 0.95
constexpr float kFeatureWidth = 0.082f;  // w, 4.2: width of the feature detector in degrees

using Planes = std::array<Plane, 3>;

std::vector<float> normalised(std::vector<float> taps) {
    double sum = 0;
    for (float t : taps) sum += t;
    for (float& t : taps) t = static_cast<float>(t / sum);
    return taps;
}

// 4.1.1, contrast sensitivity as a sum of Gaussians g(x) = a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees.
struct Gaussian {
    double a, b;
    std::vector<float> taps(int radius, double pixels_per_degree) const {
        std::vector<float> result;
        for (int i = -radius; i <= radius; ++i) {
            double x = i / pixels_per_degree, pi = std::numbers::pi;
            result.push_back(static_cast<float>(std::exp(-pi * pi * x * x / b)));
        }
        return result;
    }
    // The weight of the whole two-dimensional Gaussian: amplitude times the square of the sum of the taps.
    double weight(const std::vector<float>& taps) const {
        double sum = 0;
        for (float t : taps) sum += t;
        return a * std::sqrt(std::numbers::pi / b) * sum * sum;
    }
};
constexpr Gaussian kLuminance{.a = 1, .b = 0.0047}, kRedGreen{.a = 1, .b = 0.0053};
constexpr std::array<Gaussian, 2> kBlueYellow = {Gaussian{.a = 34.1, .b = 0.04}, Gaussian{.a = 13.5, .b = 0.025}};

Plane blurred(const Plane& in, const std::vector<float>& taps) {
    return filtered_columns(filtered_rows(in, taps), taps);
}

Planes opponent_planes(const Image8& image) {
    Planes planes;
    planes.fill(Plane(image.width, image.height));
    std::array<float, 256> linear;
    for (int i = 0; i < 256; ++i) linear[static_cast<std::size_t>(i)] = linear_from_srgb(static_cast<float>(i) / 255.0f);
    for (std::size_t i = 0; i < planes[0].values.size(); ++i) {
        const std::uint8_t* p = &image.rgba[i * 4];
        Triple o = color::ycxcz_from_xyz(color::xyz_from_linear({linear[p[0]], linear[p[1]], linear[p[2]]}));
        planes[0].values[i] = o.x, planes[1].values[i] = o.y, planes[2].values[i] = o.z;
    }
    return planes;
}

// 4.1.1: what of the picture the eye can resolve. The widest Gaussian fixes the radius of all, three standard deviations.
Planes resolved_by_eye(const Planes& in, double ppd) {
    int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(kBlueYellow[0].b / (2.0 * std::numbers::pi * std::numbers::pi)) * ppd));
    Planes out;
    out[0] = blurred(in[0], normalised(kLuminance.taps(radius, ppd)));
    out[1] = blurred(in[1], normalised(kRedGreen.taps(radius, ppd)));
    std::vector<float> wide = kBlueYellow[0].taps(radius, ppd), narrow = kBlueYellow[1].taps(radius, ppd);
    double wide_weight = kBlueYellow[0].weight(wide), narrow_weight = kBlueYellow[1].weight(narrow);
    auto share = static_cast<float>(wide_weight / (wide_weight + narrow_weight));
    out[2] = blurred(in[2], normalised(wide));
    Plane second = blurred(in[2], normalised(narrow));
    for (std::size_t i = 0; i < second.values.size(); ++i) out[2].values[i] = share * out[2].values[i] + (1 - share) * second.values[i];
    return out;
}

// 4.1.2: L*a*b*, its chroma scaled by lightness after Hunt (colours fade in the dark).
Triple perceived(const Triple& linear) {
    Triple lab = color::lab_from_xyz(color::xyz_from_linear(linear));
    return {lab.x, 0.01f * lab.x * lab.y, 0.01f * lab.x * lab.z};
}

// The same of a filtered pixel, as far as it lies in the screen's gamut.
Triple perceived(const Planes& planes, std::size_t i) {
    Triple rgb = color::linear_from_xyz(color::xyz_from_ycxcz({planes[0].values[i], planes[1].values[i], planes[2].values[i]}));
    return perceived({std::clamp(rgb.x, 0.0f, 1.0f), std::clamp(rgb.y, 0.0f, 1.0f), std::clamp(rgb.z, 0.0f, 1.0f)});
}

// Abasi, Tehran and Fairchild 2019, "Distance metrics for very large color differences" (HyAB), to the power q_c.
float color_distance(const Triple& a, const Triple& b) {
    return std::pow(std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z), kColorExponent);
}

// 4.1.3: the largest difference on a screen is between pure green and pure blue.
float largest_color_distance() {
    return color_distance(perceived({0, 1, 0}), perceived({0, 0, 1}));
}

float redistributed(float distance, float largest) {
    float cut = kCut * largest;
    return distance < cut ? kCutTarget / cut * distance : kCutTarget + (distance - cut) / (largest - cut) * (1 - kCutTarget);
}

// 4.2: a Gaussian and its first and second derivatives; positive and negative taps of a derivative sum to 1 and -1.
struct FeatureTaps {
    std::vector<float> smooth, edge, point;
};

std::vector<float> balanced(std::vector<float> taps) {
    double positive = 0, negative = 0;
    for (float t : taps) (t > 0 ? positive : negative) += std::abs(t);
    for (float& t : taps) t = static_cast<float>(t / (t > 0 ? positive : negative));
    return taps;
}

FeatureTaps feature_taps(double ppd) {
    double sigma = 0.5 * static_cast<double>(kFeatureWidth) * ppd;
    int radius = static_cast<int>(std::ceil(3 * sigma));
    FeatureTaps taps;
    for (int x = -radius; x <= radius; ++x) {
        double g = std::exp(-x * x / (2 * sigma * sigma));
        taps.smooth.push_back(static_cast<float>(g));
        taps.edge.push_back(static_cast<float>(-x * g));
        taps.point.push_back(static_cast<float>((x * x / (sigma * sigma) - 1) * g));
    }
    return {.smooth = normalised(taps.smooth), .edge = balanced(taps.edge), .point = balanced(taps.point)};
}

struct Features {
    Plane edge, point;
};

Plane magnitude(const Plane& across, const Plane& down) {
    Plane out(across.width, across.height);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
        float x = across.values[i], y = down.values[i];
        out.values[i] = std::sqrt(x * x + y * y);
    }
    return out;
}

// On the achromatic channel, brought to 0..1.
Features features(Plane luminance, const FeatureTaps& taps) {
    for (float& v : luminance.values) v = (v + 16.0f) / 116.0f;
    Plane smooth = filtered_rows(luminance, taps.smooth);
    Plane edge = magnitude(filtered_columns(filtered_rows(luminance, taps.edge), taps.smooth), filtered_columns(smooth, taps.edge));
    Plane point = magnitude(filtered_columns(filtered_rows(luminance, taps.point), taps.smooth), filtered_columns(smooth, taps.point));
    return {.edge = std::move(edge), .point = std::move(point)};
}

float feature_difference(const Features& a, const Features& b, std::size_t i) {
    float edge = std::abs(a.edge.values[i] - b.edge.values[i]), point = std::abs(a.point.values[i] - b.point.values[i]);
    return std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, kFeatureExponent);
}

} // namespace

FlipMap flip(const Image8& reference, const Image8& test, float pixels_per_degree) {
    check_same_size(reference.width, reference.height, test.width, test.height);
    FlipMap map{.width = reference.width, .height = reference.height, .error = {}};
    if (map.width == 0 || map.height == 0) return map;
    auto ppd = static_cast<double>(pixels_per_degree);
    Planes opponent_a = opponent_planes(reference), opponent_b = opponent_planes(test);
    Planes seen_a = resolved_by_eye(opponent_a, ppd), seen_b = resolved_by_eye(opponent_b, ppd);
    FeatureTaps taps = feature_taps(ppd);
    Features features_a = features(std::move(opponent_a[0]), taps), features_b = features(std::move(opponent_b[0]), taps);
    float largest = largest_color_distance();
    map.error.resize(std::size_t{map.width} * map.height);
    for (std::size_t i = 0; i < map.error.size(); ++i) {
        float color = redistributed(color_distance(perceived(seen_a, i), perceived(seen_b, i)), largest);
        map.error[i] = std::pow(color, 1.0f - feature_difference(features_a, features_b, i)); // 4.3
    }
    return map;
}

double mean(const FlipMap& map) {
    double sum = 0;
    for (float e : map.error) sum += static_cast<double>(e);
    return map.error.empty() ? 0.0 : sum / static_cast<double>(map.error.size());
}

double percentile(const FlipMap& map, double fraction) {
    if (map.error.empty()) return 0;
    std::vector<float> sorted = map.error;
    auto last = static_cast<double>(sorted.size() - 1);
    auto nth = static_cast<std::ptrdiff_t>(std::ceil(std::clamp(fraction, 0.0, 1.0) * last));
    std::nth_element(sorted.begin(), sorted.begin() + nth, sorted.end());
    return static_cast<double>(sorted[static_cast<std::size_t>(nth)]);
}

} // namespace lightbench
