// Pareto fronts, and what --budget takes from them.
#include "measure/budget.h"
#include "measure/pareto.h"

#include <gtest/gtest.h>

#include <limits>

namespace lightbench {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinite = std::numeric_limits<double>::infinity();

CostPoint point(std::string value, double ms, double rmse, double flip = 0.5) {
    CostPoint p;
    p.value = std::move(value), p.device_ms = p.q1_ms = p.q3_ms = ms, p.runs = 9, p.errors = {{"rmse", rmse}, {"flip", flip}};
    return p;
}

std::string front(std::vector<CostPoint> points, std::string_view metric = "rmse") {
    mark_fronts(points);
    std::string names;
    for (const std::size_t i : front_of(points, metric)) names += points[i].value;
    return names;
}

TEST(Front, HoldsWhatNothingBeats) {
    EXPECT_EQ(front({point("a", 4, 1), point("b", 1, 4), point("c", 2, 2), point("d", 3, 3), point("e", 5, 2)}), "bca");
}

TEST(Front, TiesGoToTheBetterAndTwinsAreBothOnIt) {
    EXPECT_EQ(front({point("a", 2, 1), point("b", 1, 1)}), "b");
    EXPECT_EQ(front({point("a", 1, 2), point("b", 1, 1)}), "b");
    EXPECT_EQ(front({point("a", 1, 1), point("b", 1, 1)}), "ab");
    EXPECT_EQ(front({point("a", 3, 0), point("b", 1, 0), point("c", 2, 0)}), "b"); // structures: equal pictures
}

TEST(Front, MetricsHaveTheirOwn) {
    const std::vector<CostPoint> points = {point("a", 1, 2, 0.1), point("b", 2, 1, 0.2)};
    EXPECT_EQ(front(points), "ab");
    EXPECT_EQ(front(points, "flip"), "a");
}

TEST(Front, WhatIsNotFiniteIsNotOnItAndHidesNothing) {
    EXPECT_EQ(front({point("a", 1, kInfinite), point("b", 2, kNaN), point("c", kNaN, 0), point("d", 3, 1)}), "d");
    EXPECT_EQ(front({}), "");
}

CostPoint noisy(std::string value, double q1, double ms, double q3, double rmse, unsigned runs = 9) {
    CostPoint p = point(std::move(value), ms, rmse);
    p.q1_ms = q1, p.q3_ms = q3, p.runs = runs;
    return p;
}

// Equal pictures whose times differ by noise alone: none is better than another.
TEST(Front, TakesNoNoiseForTruth) {
    EXPECT_EQ(front({noisy("a", 9, 10, 11, 0.1), noisy("b", 10, 10.5, 12, 0.1), noisy("c", 20, 21, 22, 0.1)}), "ab");
    EXPECT_EQ(front({noisy("a", 9, 10, 11, 0.2), noisy("b", 10, 10.5, 12, 0.1)}), "b"); // as fast, and nearer
    // One run has no quartiles: 5 % is nothing, 20 % is something.
    EXPECT_EQ(front({noisy("a", 10, 10, 10, 0, 1), noisy("b", 10.5, 10.5, 10.5, 0, 1), noisy("c", 12, 12, 12, 0, 1)}), "ab");
    EXPECT_EQ(front({noisy("a", 10, 10, 10, 0), noisy("b", 10.5, 10.5, 10.5, 0)}), "a"); // nine equal ones have
    EXPECT_EQ(front({noisy("a", kNaN, 10, kNaN, 0.2), noisy("b", kNaN, 20, kNaN, 0.1)}), "ab");
}

// As fast as c is b, as fast as b is a, but a is faster than c: b is hidden, and must not hide a.
TEST(Front, WhatIsHiddenHidesNothing) {
    EXPECT_EQ(front({noisy("a", 9, 10, 11, 3), noisy("b", 10.5, 12, 13, 2), noisy("c", 12.5, 14, 15, 1)}), "ac");
}

CostCurve three() {
    CostCurve curve;
    curve.points = {point("fast", 10, 0.3), point("mid", 20, 0.1), point("near", 40, 0.02), point("bad", 50, 0.2)};
    mark_fronts(curve.points);
    return curve;
}

TEST(Budget, TakesTheMostAccurateThatIsFastEnough) {
    const CostCurve curve = three();
    EXPECT_EQ(choose(curve, {.milliseconds = 25, .error = {}, .metric = "rmse"}).point->value, "mid");
    EXPECT_EQ(choose(curve, {.milliseconds = 1000, .error = {}, .metric = "rmse"}).point->value, "near");
    EXPECT_EQ(choose(curve, {.milliseconds = 25, .error = {}, .metric = "rmse", .time_scale = 2}).point->value, "fast");
}

TEST(Budget, TakesTheCheapestThatIsNearEnough) {
    const CostCurve curve = three();
    EXPECT_EQ(choose(curve, {.milliseconds = {}, .error = 0.1, .metric = "rmse"}).point->value, "mid");
    EXPECT_EQ(choose(curve, {.milliseconds = {}, .error = 1, .metric = "rmse"}).point->value, "fast");
    EXPECT_TRUE(choose(curve, {.milliseconds = 20, .error = 0.1, .metric = "rmse"}).fits);
}

TEST(Budget, OffersTheNearestWhereNothingFits) {
    const CostCurve curve = three();
    const Choice slow = choose(curve, {.milliseconds = 5, .error = {}, .metric = "rmse"});
    EXPECT_FALSE(slow.fits);
    EXPECT_EQ(slow.point->value, "fast");
    const Choice far = choose(curve, {.milliseconds = {}, .error = 0.001, .metric = "rmse"});
    EXPECT_FALSE(far.fits);
    EXPECT_EQ(far.point->value, "near");
    EXPECT_FALSE(choose(curve, {.milliseconds = 15, .error = 0.1, .metric = "rmse"}).fits); // near enough from 20 ms on
    EXPECT_EQ(choose(curve, {.milliseconds = 15, .error = {}, .metric = "ulp"}).point, nullptr);
}

} // namespace
} // namespace lightbench
