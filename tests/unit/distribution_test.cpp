// CT-10: facet distributions are normalised, whatever their slope; indices of refraction give back the reflectance they came from.
#include "scene/distribution.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace lightbench {
namespace {

constexpr double kPi = std::numbers::pi;

// D by SPEC S6 less its factor, with alpha as the variable.
double shape(Distribution distribution, double m, double alpha) {
    if (distribution == Distribution::gaussian) return std::exp(-std::pow(alpha / m, 2));
    return std::exp(-std::pow(std::tan(alpha) / m, 2)) / std::pow(std::cos(alpha), 4);
}

// The integral of D (N.H) over the hemisphere by the midpoint rule on rings as narrow as the lobe needs: 200 000 of them.
double hemisphere(Distribution distribution, double m) {
    constexpr int kRings = 200'000;
    double sum = 0;
    for (int i = 0; i < kRings; ++i) {
        const double alpha = (i + 0.5) * (kPi / 2) / kRings;
        sum += shape(distribution, m, alpha) * std::cos(alpha) * std::sin(alpha);
    }
    return lobe_factor(distribution, m) * sum * 2 * kPi * (kPi / 2) / kRings;
}

// Dawson's function, Daw(x) = sum of (-2)^k x^(2k+1) / (2k+1)!! (Abramowitz and Stegun 1964, 7.1.5 in the imaginary).
double dawson(double x) {
    double term = x, sum = x;
    for (int k = 1; k < 60; ++k) sum += term *= -2 * x * x / (2 * k + 1);
    return sum;
}

TEST(Distribution, IsNormalised) {
    for (Distribution distribution : {Distribution::gaussian, Distribution::beckmann})
        for (double m : {0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0, 3.0}) {
            SCOPED_TRACE(m);
            EXPECT_NEAR(hemisphere(distribution, m), kPi / 4, 1e-5 * kPi / 4);
        }
}

// The closed form over the whole line, which the hemisphere's end cuts off from m = 0.4 on.
TEST(Distribution, NarrowGaussianIsDawsons) {
    for (double m : {0.001, 0.003, 0.01, 0.1, 0.2, 0.3, 0.35}) {
        const double expected = 1 / (4 * m * dawson(m));
        EXPECT_NEAR(lobe_factor(Distribution::gaussian, m), expected, 2e-8 * expected) << m;
    }
    const double at_limit = 1 / (4 * 0.4 * dawson(0.4));
    EXPECT_NEAR(lobe_factor(Distribution::gaussian, 0.4), at_limit, 3e-8 * at_limit);
    EXPECT_LT(lobe_factor(Distribution::gaussian, 1.0) * 4 * dawson(1.0), 0.99); // what the closed form would lose there
}

TEST(Distribution, LeastRoughnessIsHeld) {
    for (Distribution distribution : {Distribution::gaussian, Distribution::beckmann})
        for (double m : {0.0, 1e-30, 9e-4}) {
            EXPECT_EQ(lobe_factor(distribution, m), lobe_factor(distribution, kLeastRoughness));
            EXPECT_TRUE(std::isfinite(lobe_factor(distribution, m)));
        }
    EXPECT_LT(lobe_factor(Distribution::beckmann, 1.1e-3), lobe_factor(Distribution::beckmann, 1e-3));
}

TEST(Distribution, IndexGivesBackItsReflectance) {
    EXPECT_EQ(ior_of_f0(glm::vec3(0)), glm::vec3(1));
    EXPECT_FLOAT_EQ(ior_of_f0(glm::vec3(0.04f)).x, 1.5f);
    for (float f0 : {1e-6f, 0.02f, 0.04f, 0.5f, 0.95f, 0.999f, 0x1.fffffep-1f}) {
        const double n = double(ior_of_f0(glm::vec3(0, f0, 0)).y), amplitude = (n - 1) / (n + 1);
        EXPECT_NEAR(amplitude * amplitude, double(f0), 2e-7 * std::sqrt(double(f0))) << f0;
    }
    const glm::vec3 gold = ior_of_f0({0.999f, 0.71f, 0.29f});
    EXPECT_TRUE(gold.x > gold.y && gold.y > gold.z);
}

} // namespace
} // namespace lightbench
