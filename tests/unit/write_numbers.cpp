// Numbers and transforms as text: what is read back is what was written.
#include "scene/transform.h"
#include "scene/write_number.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

using namespace lightbench;

namespace {

double reader_radians(double degrees) {
    return degrees * (std::numbers::pi / 180);
} // as the loader of scenes does

} // namespace

TEST(WriteNumber, DecimalsReadBack) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        const auto d = std::bit_cast<double>(random());
        EXPECT_TRUE(!std::isfinite(d) || std::strtod(decimal(d).c_str(), nullptr) == d) << decimal(d);
        const auto f = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        EXPECT_TRUE(!std::isfinite(f) || static_cast<float>(std::strtod(decimal(f).c_str(), nullptr)) == f) << decimal(f);
    }
    EXPECT_EQ(decimal(0.1f), "0.1");
    EXPECT_EQ(decimal(0.725f), "0.725");
    EXPECT_EQ(decimal(278.0), "278");
    EXPECT_EQ(decimals(glm::dvec3(1, -0.5, 3e20), ", "), "1, -0.5, 3e+20");
}

TEST(WriteNumber, DegreesReadBackWithinOneUlp) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> angle(1e-9, 3.14);
    int exact = 0;
    for (int i = 0; i < 5000; ++i) {
        const double r = angle(random), back = reader_radians(degrees_for(r));
        EXPECT_TRUE(back == r || back == std::nextafter(r, 0) || back == std::nextafter(r, 4)) << r;
        exact += back == r;
        const auto f = static_cast<float>(r);
        EXPECT_EQ(static_cast<float>(reader_radians(degrees_for(f))), f) << f;
    }
    EXPECT_GT(exact, 4000);
    for (const double whole : {0.0, 1.0, 24.0, 30.0, 36.0, 45.0, 60.0, 90.0, 180.0, 0.5, 39.3}) {
        EXPECT_EQ(decimal(degrees_for(reader_radians(whole))), decimal(whole));
        EXPECT_EQ(decimal(degrees_for(static_cast<float>(reader_radians(whole)))), decimal(whole));
    }
}

TEST(WriteNumber, TheShortestNearby) {
    EXPECT_EQ(shortest_near(0.30000000000000004, 1e-15), 0.3);
    EXPECT_EQ(shortest_near(0.30000000000000004, 0), 0.30000000000000004);
    EXPECT_EQ(shortest_near(1e-30, 1e-12), 0); // nearer to 0 than asked: not a digit is needed
    EXPECT_TRUE(std::isnan(shortest_near(std::nan(""), 1)));
}

// glm's rotations are the independent oracle of the composition.
TEST(Transform, ComposesAsDocumented) {
    const TransformParts p{{1, 2, 3}, {20, -40, 70}, {2, 0.5, -3}};
    glm::dmat4 m = glm::translate(glm::dmat4(1), p.translate);
    for (int axis : {2, 1, 0}) {
        glm::dvec3 a(0);
        a[axis] = 1;
        m = glm::rotate(m, glm::radians(p.rotate[axis]), a);
    }
    m = glm::scale(m, p.scale);
    for (int c = 0; c < 4; ++c) EXPECT_LT(glm::length(m[c] - world_from_object(p)[c]), 1e-14);
    const glm::dmat4 quarter = world_from_object({{}, {0, 90, 0}, glm::dvec3(1)});
    EXPECT_EQ(quarter * glm::dvec4(0, 0, 1, 1), glm::dvec4(1, 0, 0, 1)); // exactly
}

TEST(Transform, ComesApartInTheNumbersThatWereWritten) {
    const TransformParts p{{0.1, -2, 1e6}, {20, -35.5, 170}, {2, 0.3, 7}};
    const auto q = transform_parts(world_from_object(p));
    ASSERT_TRUE(q);
    EXPECT_EQ(q->translate, p.translate);
    EXPECT_EQ(q->rotate, p.rotate);
    EXPECT_EQ(q->scale, p.scale);
    EXPECT_EQ(world_from_object(*q), world_from_object(p));
}

TEST(Transform, AnyRotationComesBack) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> angle(-180, 180), size(0.01, 50);
    for (int i = 0; i < 3000; ++i) {
        TransformParts p{{angle(random), angle(random), angle(random)},
                         {angle(random), angle(random), angle(random)},
                         {size(random), size(random), size(random)}};
        if (i % 5 == 0) p.rotate.y = i % 2 ? 90 : -90; // gimbal lock
        if (i % 7 == 0) p.scale[i % 3] *= -1;
        const glm::dmat4 m = world_from_object(p);
        const auto q = transform_parts(m);
        ASSERT_TRUE(q) << i;
        const glm::dmat4 back = world_from_object(*q);
        for (int c = 0; c < 4; ++c) EXPECT_LT(glm::length(back[c] - m[c]), 1e-13 * glm::length(m[c])) << i;
    }
}

TEST(Transform, WhatIsNoPlacementIsNone) {
    glm::dmat4 shear(1);
    shear[1][0] = 0.001;
    EXPECT_FALSE(transform_parts(shear));
    EXPECT_FALSE(transform_parts(glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 1))));
    glm::dmat4 projective(1);
    projective[0].w = 0.5;
    EXPECT_FALSE(transform_parts(projective));
    glm::dmat4 broken(1);
    broken[0].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(transform_parts(broken));
}
