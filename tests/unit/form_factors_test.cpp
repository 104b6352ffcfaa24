// Form factors: tables of the hemi-cube sum to one, anchors of the literature, closed forms against 60 digits (HC-1, HC-4, HC-5, HC-10).
#include "radiosity/form_factors.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace lightbench {
namespace {

using Precise = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

// The catalogue's own forms, in digits enough for what they lose.
Precise parallel_oracle(Precise a, Precise b, Precise c) {
    const Precise x = a / c, y = b / c, p = sqrt(1 + x * x), q = sqrt(1 + y * y), pi = acos(Precise(-1));
    return 2 / (pi * x * y) *
           (log(p * q / sqrt(1 + x * x + y * y)) + x * q * atan(x / q) + y * p * atan(y / p) - x * atan(x) - y * atan(y));
}

Precise perpendicular_oracle(Precise a, Precise b, Precise c) {
    const Precise h = c / a, w = b / a, h2 = h * h, w2 = w * w, d = h2 + w2, pi = acos(Precise(-1));
    const Precise logs =
        log((1 + w2) * (1 + h2) / (1 + d)) + w2 * log(w2 * (1 + d) / ((1 + w2) * d)) + h2 * log(h2 * (1 + d) / ((1 + h2) * d));
    return (w * atan(1 / w) + h * atan(1 / h) - sqrt(d) * atan(1 / sqrt(d)) + logs / 4) / (pi * w);
}

Precise discs_oracle(Precise r1, Precise r2, Precise h) {
    const Precise a = r1 / h, b = r2 / h, x = 1 + (1 + b * b) / (a * a);
    return (x - sqrt(x * x - 4 * (b / a) * (b / a))) / 2;
}

const double kSizes[] = {1e-6, 1e-4, 1e-2, 0.3, 0.49, 0.51, 1, 2, 30, 1e3, 1e5};

template <class F, class Oracle> void expect_close(const F& f, const Oracle& oracle) {
    double worst = 0;
    for (double a : kSizes)
        for (double b : kSizes)
            for (double c : kSizes) {
                const Precise expected = oracle(a, b, c);
                worst = std::max(worst, std::abs(static_cast<double>((f(a, b, c) - expected) / expected)));
            }
    EXPECT_LE(worst, 1e-12);
    fmt::print("worst relative error {:.2e}\n", worst);
}

using Corners = std::vector<glm::dvec3>;
// Seen from below: counter-clockwise for a point under it.
Corners ceiling(double x0, double x1, double y0, double y1, double z) {
    return {{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}};
}

} // namespace

TEST(FormFactors, TablesSumToOne) {
    for (unsigned n : {2u, 50u, 64u, 100u, 128u, 512u}) {
        const DeltaFormFactors exact = exact_delta_form_factors(n);
        ASSERT_EQ(exact.top.size(), n * n);
        ASSERT_EQ(exact.side.size(), n * n / 2);
        EXPECT_NEAR(sum(exact.top), 0.554126424, 4e-10) << n;
        EXPECT_NEAR(sum(exact.side), 0.111468394, 4e-10) << n;
        EXPECT_NEAR(sum(exact.top) + 4 * sum(exact.side), 1, 1e-13) << n;
        const std::vector<std::uint32_t> table = delta_form_factors(n);
        ASSERT_EQ(table.size(), n * n * 3 / 2);
        const auto middle = table.begin() + n * n;
        const std::uint64_t top = std::accumulate(table.begin(), middle, std::uint64_t{0}),
                            side = std::accumulate(middle, table.end(), std::uint64_t{0});
        EXPECT_EQ(top + 4 * side, std::uint64_t{1} << 31) << n;
        for (std::size_t i = 0; i < table.size(); ++i) {
            const double value = i < n * n ? exact.top[i] : exact.side[i - n * n];
            ASSERT_NEAR(table[i], value * 0x1p31, 1.0 + 4 * value) << n << ' ' << i;
        }
    }
}

// HC-1: the sum by the formula at the centers of pixels errs by the square of their width.
TEST(FormFactors, SumsAtPixelCentersConverge) {
    EXPECT_NEAR(sum_at_pixel_centers(32) - 1, 5.3e-4, 1e-5);
    EXPECT_NEAR(sum_at_pixel_centers(64) - 1, 1.3e-4, 5e-6);
    EXPECT_NEAR(sum_at_pixel_centers(256) - 1, 8.3e-6, 1e-7);
    for (unsigned n = 16; n < 256; n *= 2) {
        const double coarse = std::abs(sum_at_pixel_centers(n) - 1), fine = std::abs(sum_at_pixel_centers(2 * n) - 1);
        EXPECT_NEAR(std::log2(fine / coarse), -2, 0.1) << n;
        EXPECT_LE(coarse, 0.6 / (double(n) * n)) << n;
    }
}

// Centres of pixels are what S28 writes; the integral over a pixel goes to them as pixels shrink.
TEST(FormFactors, TablesAreWhatIsIntegrated) {
    const unsigned n = 256;
    const DeltaFormFactors exact = exact_delta_form_factors(n);
    const double side = 2.0 / n, area = side * side;
    for (unsigned j = 0; j < n; j += 5)
        for (unsigned i = 0; i < n; i += 5) {
            const double x = -1 + side * (i + 0.5), y = -1 + side * (j + 0.5), z = side * (j + 0.5), r = x * x + y * y + 1;
            EXPECT_NEAR(exact.top[j * n + i], area / (std::numbers::pi * r * r), 1e-4 * area);
            const double s = x * x + z * z + 1;
            if (j < n / 2) {
                EXPECT_NEAR(exact.side[j * n + i], z * area / (std::numbers::pi * s * s), 1e-4 * area);
            }
        }
}

TEST(FormFactors, Anchors) {
    EXPECT_NEAR(parallel_rectangles(1, 1, 1), 0.199824895698, 1e-12);
    EXPECT_NEAR(parallel_rectangles(2, 1, 1), 0.285875385, 5e-10);
    EXPECT_NEAR(perpendicular_rectangles(1, 1, 1), 0.200043776075, 1e-12);
    EXPECT_NEAR(perpendicular_rectangles(1, 1, 2), 0.232852603, 5e-10);
    EXPECT_NEAR(perpendicular_rectangles(1, 2, 1), 0.116426301, 5e-10);
    EXPECT_NEAR(coaxial_discs(1, 1, 1), 0.381966011250, 1e-12);
    EXPECT_NEAR(parallel_rectangles(1, 1, 1) + 4 * perpendicular_rectangles(1, 1, 1), 1, 1e-14);
}

TEST(FormFactors, ClosedFormsHoldEverywhere) {
    expect_close(parallel_rectangles, parallel_oracle);
    expect_close(perpendicular_rectangles, perpendicular_oracle);
    expect_close(coaxial_discs, discs_oracle);
}

// B-3: a point under the corner of a rectangle; and the whole half-space.
TEST(FormFactors, PointToPolygon) {
    const double corner = (std::sqrt(0.5) * std::atan(std::sqrt(0.5)) * 2) / (2 * std::numbers::pi);
    EXPECT_NEAR(point_to_polygon({0, 0, 0}, {0, 0, 1}, ceiling(0, 1, 0, 1, 1)), corner, 1e-15);
    EXPECT_NEAR(point_to_polygon({0, 0, 0}, {0, 0, 1}, ceiling(-1, 1, -1, 1, 1)), 0.554126424, 4e-10);
    EXPECT_NEAR(point_to_polygon({0, 0, 0}, {0, 0, 1}, ceiling(-1e9, 1e9, -1e9, 1e9, 1)), 1, 1e-8);
    EXPECT_NEAR(point_to_polygon({3, 4, 5}, {0, 0, 1}, ceiling(2, 4, 3, 5, 6)), 0.554126424, 4e-10);
}

// HC-10: a side of the hemi-cube that goes on below the horizon gives what is above; coplanar, behind, and seen from its back give 0.
TEST(FormFactors, PointToPolygonAtTheHorizon) {
    const Corners side{{1, -1, 1}, {1, 1, 1}, {1, 1, -3}, {1, -1, -3}};
    EXPECT_NEAR(point_to_polygon({0, 0, 0}, {0, 0, 1}, side), 0.111468394, 4e-10);
    EXPECT_EQ(point_to_polygon({0, 0, 0}, {0, 0, 1}, Corners(side.rbegin(), side.rend())), 0);
    EXPECT_EQ(point_to_polygon({0, 0, 0}, {0, 0, 1}, ceiling(-1, 1, -1, 1, -1)), 0);
    EXPECT_EQ(point_to_polygon({0, 0, 0}, {0, 0, 1}, ceiling(1, 2, 1, 2, 0)), 0);
}

// Between areas: the mean over points of the one of what they see of the other.
TEST(FormFactors, PointsAddUpToAreas) {
    double parallel = 0, perpendicular = 0;
    const int n = 64;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const glm::dvec3 p((i + 0.5) / n, (j + 0.5) / n, 0);
            parallel += point_to_polygon(p, {0, 0, 1}, ceiling(0, 1, 0, 1, 1)) / (n * n);
            perpendicular += point_to_polygon(p, {0, 0, 1}, Corners{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}) / (n * n);
        }
    EXPECT_NEAR(parallel, 0.199824895698, 1e-4);
    EXPECT_NEAR(perpendicular, 0.200043776075, 1e-3);
}

} // namespace lightbench
