// Statistics of runs against values worked out by hand.
#include "measure/statistics.h"

#include "measure/rounds.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace lightbench {
namespace {

TEST(Statistics, QuartilesAreInterpolated) {
    const Quartiles q = quartiles({4, 1, 3, 2});
    EXPECT_DOUBLE_EQ(q.q1, 1.75);
    EXPECT_DOUBLE_EQ(q.median, 2.5);
    EXPECT_DOUBLE_EQ(q.q3, 3.25);
    const Quartiles one = quartiles({7});
    EXPECT_EQ(one.q1, 7);
    EXPECT_EQ(one.q3, 7);
}

// Tables of the sign test: n = 6: (1, 6), 0.969; n = 9: (2, 8), 0.961; n = 20: (6, 15), 0.959.
TEST(Statistics, TheIntervalOfTheMedianIsThatOfTheTables) {
    std::vector<double> sample;
    for (int i = 1; i <= 5; ++i) sample.push_back(i);
    EXPECT_FALSE(median_interval(sample));
    sample.push_back(6);
    EXPECT_EQ(median_interval(sample)->low, 1);
    EXPECT_EQ(median_interval(sample)->high, 6);
    for (int i = 7; i <= 9; ++i) sample.push_back(i);
    EXPECT_EQ(median_interval(sample)->low, 2);
    EXPECT_EQ(median_interval(sample)->high, 8);
    for (int i = 10; i <= 20; ++i) sample.push_back(i);
    EXPECT_EQ(median_interval(sample)->low, 6);
    EXPECT_EQ(median_interval(sample)->high, 15);
}

// Runs that are exponentially distributed, as skew as times get: the median ln 2 lies within as often as was promised.
TEST(Statistics, TheIntervalHoldsTheMedianWhateverTheDistribution) {
    std::mt19937 rng(1);
    std::exponential_distribution<double> draw(1);
    int held = 0;
    for (int i = 0; i < 4000; ++i) {
        std::vector<double> sample(15);
        for (double& x : sample) x = draw(rng);
        const auto interval = median_interval(sample);
        held += interval->low <= std::log(2.0) && std::log(2.0) <= interval->high;
    }
    EXPECT_GE(held / 4000.0, 0.95);
    EXPECT_LE(held / 4000.0, 0.98); // (4, 12) of 15: 0.965
}

TEST(Statistics, SlopesAreThoseOfPowers) {
    EXPECT_NEAR(log_slope({{1, 8}, {2, 2}, {4, 0.5}}).value(), -2, 1e-12);
    EXPECT_NEAR(log_slope({{10, 3}, {1000, 3}}).value(), 0, 1e-12);
    EXPECT_FALSE(log_slope({{3, 1}}));
    EXPECT_FALSE(log_slope({{3, 1}, {3, 2}}));
}

TEST(Rounds, TurnsUntilAllAreSure) {
    std::string order;
    const auto run = [&](std::size_t i) { return order += static_cast<char>('A' + i), 10.0 + double(i); };
    const auto timed = time_in_rounds(3, run, [] { return 0.0; }, {});
    EXPECT_EQ(order, "ABCABCABCABCABCABCABC"); // 7 equal runs make the interval of the first look
    EXPECT_TRUE(timed[2].settled);
    EXPECT_EQ(timed[2].milliseconds, std::vector<double>(7, 12.0));
}

// What is claimed with 95 % holds under the rule that ends the runs: looking after each would find luck too often (43 % of two values, a
// tenth apart).
TEST(Rounds, TheStoppingRuleKeepsItsPromise) {
    std::mt19937 rng(1);
    std::bernoulli_distribution slow(0.43);
    std::lognormal_distribution<double> skew(0, 0.1);
    int wrong_of_two = 0, wrong_of_skew = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto two = time_in_rounds(
            1, [&](std::size_t) { return slow(rng) ? 11.1 : 10.0; }, [] { return 0.0; }, {})[0];
        wrong_of_two += two.settled && quartiles(two.milliseconds).median > 10.5;
        const auto one = time_in_rounds(
            1, [&](std::size_t) { return skew(rng); }, [] { return 0.0; }, {})[0];
        wrong_of_skew += one.settled && std::abs(quartiles(one.milliseconds).median - 1) > 0.05;
    }
    EXPECT_LE(wrong_of_two / 2000.0, 0.05);
    EXPECT_LE(wrong_of_skew / 2000.0, 0.05);
}

// An empty loop of 10 that wobbles by a tenth: formulas of 1 and 0 beside it are judged by what is left of them.
TEST(Rounds, NetTimesAreJudged) {
    int round = 0;
    const auto run = [&](std::size_t i) {
        return i == 0 ? 10.0 + (round++ % 2) : i == 1 ? 11.0 + (round % 2 ? 0 : 1) : 10.0 + 0.1 * (round % 3);
    };
    const auto timed = time_in_rounds(3, run, [] { return 0.0; }, {.most = 12, .net = true});
    EXPECT_EQ(timed[1].milliseconds, std::vector<double>(12, 1.0));
    EXPECT_TRUE(timed[0].settled && timed[1].settled);
    EXPECT_FALSE(timed[2].settled); // gross it is within 5 %
}

TEST(Rounds, AStopLeavesWholeRounds) {
    int runs = 0;
    const auto stopped_after = [&](int most) {
        runs = 0;
        return time_in_rounds(
            2, [&](std::size_t) { return double(++runs); }, [] { return 0.0; }, {}, [&, most] { return runs >= most; });
    };
    EXPECT_EQ(stopped_after(5)[0].milliseconds, (std::vector<double>{1, 3}));
    EXPECT_EQ(stopped_after(5)[1].milliseconds, (std::vector<double>{2, 4}));
    EXPECT_EQ(runs, 5);
    EXPECT_TRUE(stopped_after(2)[0].milliseconds.empty());
}

TEST(Rounds, CapsAreKeptAndSaid) {
    int runs = 0;
    const auto noisy = [&](std::size_t) { return runs++ % 2 ? 10.0 : 20.0; };
    EXPECT_EQ(time_in_rounds(1, noisy, [] { return 0.0; }, {.most = 9})[0].milliseconds.size(), 9u);
    double now = 0;
    const auto slow = time_in_rounds(1, noisy, [&] { return now += 1000; }, {.milliseconds = 3500});
    EXPECT_EQ(slow[0].milliseconds.size(), 4u);
    EXPECT_FALSE(slow[0].settled);
    EXPECT_EQ(time_in_rounds(2, noisy, [] { return 1e9; }, {.milliseconds = 0})[1].milliseconds.size(), 1u);
}

} // namespace
} // namespace lightbench
