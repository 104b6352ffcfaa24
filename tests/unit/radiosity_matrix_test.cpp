// The oracle of radiosity against closed forms: direct solution, reciprocity, balance, sums of energy.
#include "radiosity/matrix.h"

#include "shared/radiosity.h"

#include <gmock/gmock.h>
#include <random>

namespace lightbench {
namespace {

// Reciprocal up to noise; far from closed.
struct Random {
    std::mt19937 engine{7};
    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
    std::vector<double> areas(std::size_t n) {
        std::vector<double> a(n);
        for (double& x : a) x = number(0.5, 50); // a ratio of 100 (HC-8)
        return a;
    }
    FormMatrix matrix(const std::vector<double>& areas, double noise) {
        FormMatrix m = make_form_matrix(areas.size());
        for (std::size_t i = 0; i < m.size; ++i)
            for (std::size_t j = i + 1; j < m.size; ++j) {
                const double exchange = number(0.1, 1) * 0.02 / static_cast<double>(m.size);
                m.at(i, j) = exchange / areas[i];
                m.at(j, i) = exchange / areas[j] * (1 + noise);
            }
        return m;
    }
};

TEST(RadiosityMatrix, TwoPatchesThatSeeEachOther) {
    FormMatrix m = make_form_matrix(2);
    m.at(0, 1) = 0.2, m.at(1, 0) = 0.4;
    const std::vector<glm::dvec3> e{{1, 2, 0}, {0, 3, 0}}, rho{{0.5, 0.25, 0.9}, {0.75, 0.5, 0.9}};
    const auto b = solve_directly(m, e, rho);
    for (int c = 0; c < 3; ++c) {
        const double p = rho[0][c] * 0.2, q = rho[1][c] * 0.4, det = 1 - p * q;
        EXPECT_NEAR(b[0][c], (e[0][c] + p * e[1][c]) / det, 1e-14);
        EXPECT_NEAR(b[1][c], (e[1][c] + q * e[0][c]) / det, 1e-14);
    }
}

// Pivots vanish on the way: rows must change places, or the solution is lost.
TEST(RadiosityMatrix, SolvesWhatTheMatrixWasMultipliedWith) {
    Random random;
    const auto areas = random.areas(60);
    FormMatrix m = random.matrix(areas, 0);
    balance(m, areas, 1e-13, 10'000);
    std::vector<glm::dvec3> b(60), e(60), rho(60, glm::dvec3(0.9, 0.5, 0));
    for (glm::dvec3& x : b) x = {random.number(0, 1), random.number(0, 1), random.number(0, 1)};
    for (std::size_t i = 0; i < 60; ++i) {
        glm::dvec3 received(0);
        for (std::size_t j = 0; j < 60; ++j) received += m.at(i, j) * b[j];
        e[i] = b[i] - rho[i] * received;
    }
    const auto solved = solve_directly(m, e, rho);
    for (std::size_t i = 0; i < 60; ++i)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(solved[i][c], b[i][c], 1e-13);
}

TEST(RadiosityMatrix, ReadsRowsInUnitsOfTheHemicube) {
    const std::vector<std::uint32_t> rows{0, gpu_layout::kHemicubeOne, gpu_layout::kHemicubeOne / 4, 3};
    const FormMatrix m = from_rows(rows, 2);
    EXPECT_EQ(m.at(0, 1), 1.0);
    EXPECT_EQ(m.at(1, 0), 0.25);
    EXPECT_EQ(m.at(1, 1), 3 * 0x1p-31);
    EXPECT_EQ(m.row_sum(1), 0.25 + 3 * 0x1p-31);
}

TEST(RadiosityMatrix, ReportsAndEnforcesReciprocity) {
    Random random;
    const auto areas = random.areas(40);
    FormMatrix m = random.matrix(areas, -0.3);
    const Reciprocity before = reciprocity_error(m, areas);
    EXPECT_NEAR(before.worst, 0.3, 1e-12);
    EXPECT_NEAR(before.mean, 0.3, 1e-12);
    EXPECT_EQ(reciprocity_error(random.matrix(areas, 0), areas).mean < 1e-15, true);
    m.at(3, 17) *= 4; // the worst pair is found
    EXPECT_EQ(reciprocity_error(m, areas).i, 3u);
    EXPECT_EQ(reciprocity_error(m, areas).j, 17u);
    enforce_reciprocity(m, areas);
    EXPECT_LE(reciprocity_error(m, areas).worst, 4.5e-16); // two quotients, two products: 2^-53 each, of which half can pile up
}

TEST(RadiosityMatrix, GatheringAndShootingAgreeWhereRowsAreReciprocal) {
    Random random;
    const auto areas = random.areas(20);
    const FormMatrix m = random.matrix(areas, 0), shots = from_shots(m, areas);
    for (std::size_t k = 0; k < m.factors.size(); ++k) EXPECT_NEAR(shots.factors[k], m.factors[k], 1e-15 * m.factors[k]);
}

// Rows, reciprocity and furnace hold together (RS-3).
TEST(RadiosityMatrix, BalancedMatricesAreClosedAndReciprocal) {
    Random random;
    const auto areas = random.areas(100);
    FormMatrix m = random.matrix(areas, 0.2);
    const Balance done = balance(m, areas, 1e-13, 10'000);
    EXPECT_LE(done.closure_error, 1e-13);
    EXPECT_LT(done.rounds, 200u);
    EXPECT_LE(reciprocity_error(m, areas).worst, 1e-15);
    for (std::size_t i = 0; i < m.size; ++i) EXPECT_NEAR(m.row_sum(i), 1, 2e-13);
    const std::vector<glm::dvec3> e(100, {1, 2, 3}), rho(100, {0.5, 0.9, 0.999});
    const auto b = solve_directly(m, e, rho);
    for (const glm::dvec3& x : b)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(x[c] * (1 - rho[0][c]) / e[0][c], 1, 1e-9);
    const EnergySums sums = energy_sums(m, areas, e, rho, b);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(sums.absorbed[c] / sums.emitted[c], 1, 1e-9);
        EXPECT_NEAR(sums.escaped[c] / sums.emitted[c], 0, 1e-9);
    }
}

TEST(RadiosityMatrix, SaysWhereNoBalanceExists) {
    FormMatrix m = make_form_matrix(2);
    m.at(0, 1) = 0.5, m.at(1, 0) = 0.25;
    const Balance done = balance(m, std::vector<double>{1, 2}, 1e-12, 50);
    EXPECT_EQ(done.rounds, 50u);
    EXPECT_GT(done.closure_error, 0.1);
}

} // namespace
} // namespace lightbench
