// Progressive refinement and Gauss-Seidel on the device against closed forms and a direct solution in double precision (RS-1 to RS-8).
#include "images/radiosity_rooms.h"

#include "shared/radiosity.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lightbench {
namespace {

class RadiositySolver : public gpu::GpuTest {
  protected:
    ProgressiveSolver solver_of(const Room& room, unsigned batch) {
        return ProgressiveSolver(device(), room.mesh, room.emission, room.reflectance, batch);
    }
};

// Relative, of each value that is expected to be above 0.
double largest_difference(const std::vector<glm::vec3>& values, const std::vector<glm::dvec3>& expected) {
    double worst = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (expected[i][c] > 0) worst = std::max(worst, std::abs(values[i][c] / expected[i][c] - 1));
    return worst;
}

bool same_bits(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec3)) == 0;
}

void expect_same_bits(const RadiosityState& a, const RadiosityState& b) {
    EXPECT_TRUE(same_bits(a.radiosity, b.radiosity));
    EXPECT_TRUE(same_bits(a.unshot, b.unshot));
    EXPECT_TRUE(same_bits(a.received, b.received));
    EXPECT_TRUE(same_bits(a.unshot_carry, b.unshot_carry));
    EXPECT_TRUE(same_bits(a.received_carry, b.received_carry));
    EXPECT_EQ(a.shots, b.shots);
}

// RS-3: after unshot / E < 1e-6 at most 1e-5 from the direct solution; RS-4 at every step.
TEST_F(RadiositySolver, ConvergesToTheDirectSolutionAndLosesNothingOnTheWay) {
    const Room room = random_room(200, 4, 0.85f, 1);
    ProgressiveSolver solver = solver_of(room, 8);
    Ledger last = solver.ledger();
    double off = 0;
    while (last.unshot_fraction() >= 3e-7) {
        ASSERT_GT(shoot_batch(device(), solver, room, 8), 0u);
        const Ledger now = solver.ledger();
        for (int c = 0; c < 3; ++c) {
            off = std::max(off, std::abs(now.absorbed[c] + now.unshot[c] + now.escaped[c] - now.emitted[c]) / now.emitted[c]);
            EXPECT_LE(now.unshot[c], last.unshot[c]);
        }
        last = now;
    }
    EXPECT_LE(off, 1e-5);
    const double difference = largest_difference(solver.state().radiosity, room.direct_solution());
    EXPECT_LE(difference, 1e-5);
    fmt::print("ledger off by {:.2g}, direct solution by {:.2g}, {} shots\n", off, difference, solver.state().shots);
}

TEST_F(RadiositySolver, FullMatrixGivesTheDirectSolution) {
    const Room room = random_room(200, 1, 0.9f, 2);
    gpu::Buffer matrix = full_matrix(device(), room);
    const FullSolution full = solve_full(device(), room.mesh, matrix, room.emission, room.reflectance, 1e-7, 200);
    EXPECT_LT(full.sweeps, 100u);
    EXPECT_EQ(full.closure_error, 0);
    FormMatrix m = make_form_matrix(200);
    for (std::size_t i = 0; i < 200; ++i)
        for (std::size_t j = 0; j < 200; ++j) m.at(i, j) = room.rows[i][j] / double{gpu_layout::kHemicubeOne};
    const std::vector<glm::dvec3> e(room.emission.begin(), room.emission.end()), rho(room.reflectance.begin(), room.reflectance.end());
    const double difference = largest_difference(full.radiosity, solve_directly(m, e, rho));
    EXPECT_LE(difference, 1e-5);
    fmt::print("off by {:.2g} after {} sweeps\n", difference, full.sweeps);
}

// RS-1: B = E / (1 - rho), relative to within 1e-5 / (1 - rho).
TEST_F(RadiositySolver, FurnaceOfTheFullMatrix) {
    for (const float rho : {0.0f, 0.3f, 0.9f, 0.99f, 0.999f}) {
        Room room = random_room(70, 1, 0, 3);
        room.emission.assign(70, {1, 2, 0}), room.reflectance.assign(70, glm::vec3(rho));
        gpu::Buffer matrix = full_matrix(device(), room);
        const FullSolution full = solve_full(device(), room.mesh, matrix, room.emission, room.reflectance, 1e-6, 5000);
        const double k = 1 / (1 - double{rho});
        const double off = largest_difference(full.radiosity, std::vector<glm::dvec3>(70, {k, 2 * k, 0}));
        EXPECT_LE(off, 1e-5 * k) << rho;
        fmt::print("rho {}: off by {:.2g} of {:.2g}, {} sweeps\n", rho, off, 1e-5 * k, full.sweeps);
    }
}

// All patches shoot at once, over and over: a row is the same to whomever it belongs.
TEST_F(RadiositySolver, FurnaceByShooting) {
    for (const float rho : {0.0f, 0.5f, 0.9f, 0.999f}) {
        const Room room = sphere_room(16, {1, 2, 0}, glm::vec3(rho));
        ProgressiveSolver solver = solver_of(room, 16);
        gpu::Buffer rows = full_matrix(device(), room);
        for (int i = 0; solver.ledger().unshot_fraction() > 1e-6 && i < 30; ++i) {
            gpu::Recorder recorder(device());
            for (int batch = 0; batch < 200; ++batch) {
                solver.record_choice(recorder, 16);
                solver.record_shots(recorder, rows);
            }
            recorder.submit_and_wait();
        }
        const double k = 1 / (1 - double{rho});
        const double off = largest_difference(solver.state().radiosity, std::vector<glm::dvec3>(16, {k, 2 * k, 0}));
        EXPECT_LE(off, 1e-5 * k) << rho;
        fmt::print("rho {}: off by {:.2g} of {:.2g}, {} shots\n", rho, off, 1e-5 * k, solver.state().shots);
    }
}

// RS-2: F11 = 0, F12 = 1, F21 = A1 / A2, F22 = 1 - A1 / A2. With b = F21: B1 = E1 + rho1 B2, B2 = E2 + rho2 (b B1 + (1 - b) B2).
TEST_F(RadiositySolver, TwoSpheresWithOneCenter) {
    Room room = two_spheres(1, 4);
    room.emission = {{1, 0, 2}, {0, 1, 3}}, room.reflectance = {{0.5f, 0.7f, 0.9f}, {0.8f, 0.6f, 0.25f}};
    std::vector<glm::dvec3> expected(2);
    for (int c = 0; c < 3; ++c) {
        const double e1 = room.emission[0][c], e2 = room.emission[1][c], r1 = room.reflectance[0][c], r2 = room.reflectance[1][c];
        expected[1][c] = (e2 + r2 * 0.25 * e1) / (1 - r2 * 0.75 - r2 * 0.25 * r1);
        expected[0][c] = e1 + r1 * expected[1][c];
    }
    ProgressiveSolver solver = solver_of(room, 1);
    shoot_until(device(), solver, room, 1, 1e-8);
    EXPECT_LE(largest_difference(solver.state().radiosity, expected), 1e-6);
    gpu::Buffer matrix = full_matrix(device(), room);
    const FullSolution full = solve_full(device(), room.mesh, matrix, room.emission, room.reflectance, 1e-7, 200);
    EXPECT_LE(largest_difference(full.radiosity, expected), 1e-6);
}

// Rows that sum to 1.05 would grow without end; both solvers bring them down to 1, and say so (RS-1).
TEST_F(RadiositySolver, RowsAboveOneAreBroughtDown) {
    Room room = random_room(32, 1, 0, 4);
    for (auto& row : room.rows)
        for (std::uint32_t& f : row) f += f / 20;
    room.reflectance.assign(32, glm::vec3(0.96f));
    ProgressiveSolver solver = solver_of(room, 16);
    shoot_until(device(), solver, room, 16, 1e-6);
    EXPECT_LE(largest_difference(solver.state().radiosity, room.direct_solution()), 1e-5 / 0.04);
    EXPECT_EQ(solver.ledger().escaped, glm::dvec3(0));
    gpu::Buffer matrix = full_matrix(device(), room);
    EXPECT_NEAR(solve_full(device(), room.mesh, matrix, room.emission, room.reflectance, 1e-6, 500).closure_error, 0.05, 1e-6);
}

TEST_F(RadiositySolver, LedgerCountsWhatLeavesAnOpenScene) {
    Room room = random_room(50, 2, 0.9f, 5);
    for (auto& row : room.rows)
        for (std::size_t j = 0; j < row.size(); j += 3) row[j] = 0;
    ProgressiveSolver solver = solver_of(room, 4);
    shoot_until(device(), solver, room, 4, 1e-6);
    const Ledger l = solver.ledger();
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(l.escaped[c], 0.2 * l.emitted[c]);
        EXPECT_NEAR((l.absorbed[c] + l.unshot[c] + l.escaped[c]) / l.emitted[c], 1, 1e-5);
    }
    EXPECT_LE(largest_difference(solver.state().radiosity, room.direct_solution()), 1e-5);
}

// RS-5: in a box that is alike everywhere the very first picture is the furnace.
TEST_F(RadiositySolver, AmbientTermIsWhatIsStillMissing) {
    Room room = random_room(64, 4, 0, 6);
    room.emission.assign(64, {1, 3, 0}), room.reflectance.assign(64, {0.8f, 0.25f, 0.5f});
    ProgressiveSolver solver = solver_of(room, 16);
    const RadiosityState first = solver.state();
    const glm::vec3 ambient = solver.ambient();
    for (std::size_t i = 0; i < 64; ++i) {
        EXPECT_NEAR((first.radiosity[i] + room.reflectance[i] * ambient).x / 5, 1, 1e-5);
        EXPECT_NEAR((first.radiosity[i] + room.reflectance[i] * ambient).y / 4, 1, 1e-5);
    }
    EXPECT_EQ(ambient.z, 0);
    shoot_until(device(), solver, room, 16, 1e-6);
    EXPECT_LE(solver.ambient().x, 1e-6f * 5);
    EXPECT_LE(solver.ambient().y, 1e-6f * 4);
}

// RS-6.
TEST_F(RadiositySolver, NothingReflectsNothingShinesOnePatch) {
    Room black = random_room(30, 3, 0, 7);
    ProgressiveSolver solver = solver_of(black, 16);
    EXPECT_EQ(shoot_batch(device(), solver, black, 16), 5u); // elements 0, 7, 14, 21, 28 shine
    EXPECT_EQ(solver.ledger().unshot, glm::dvec3(0));
    EXPECT_TRUE(same_bits(solver.state().radiosity, black.emission));
    EXPECT_EQ(shoot_batch(device(), solver, black, 16), 0u);
    EXPECT_EQ(solver.state().shots, 5u);

    Room dark = random_room(30, 3, 0.9f, 7);
    dark.emission.assign(30, glm::vec3(0));
    ProgressiveSolver nothing = solver_of(dark, 2);
    EXPECT_EQ(nothing.ledger().unshot_fraction(), 0);
    EXPECT_EQ(shoot_batch(device(), nothing, dark, 2), 0u);
    EXPECT_TRUE(same_bits(nothing.state().radiosity, dark.emission));
    EXPECT_EQ(nothing.ambient(), glm::vec3(0));

    Room one = make_room({2.0}, 1);
    one.rows = {{0}}, one.emission = {{1, 2, 3}}, one.reflectance = {glm::vec3(0.5f)};
    ProgressiveSolver alone = solver_of(one, 1);
    EXPECT_EQ(shoot_batch(device(), alone, one, 1), 1u);
    EXPECT_TRUE(same_bits(alone.state().radiosity, one.emission));
    EXPECT_EQ(alone.ledger().escaped, glm::dvec3(2, 4, 6));
    gpu::Buffer matrix = full_matrix(device(), one);
    EXPECT_TRUE(same_bits(solve_full(device(), one.mesh, matrix, one.emission, one.reflectance, 1e-6, 10).radiosity, one.emission));
}

// RS-7: twice the light or twice the lengths change no other bit.
TEST_F(RadiositySolver, PowersOfTwoChangeNoOtherBit) {
    const Room room = random_room(40, 2, 0.8f, 8);
    Room scaled = room;
    for (glm::vec3& e : scaled.emission) e *= 0x1p9f;
    for (Element& e : scaled.mesh.elements) e.area *= 0x1p-6;
    ProgressiveSolver a = solver_of(room, 4), b = solver_of(scaled, 4);
    EXPECT_EQ(shoot_until(device(), a, room, 4, 1e-5), shoot_until(device(), b, scaled, 4, 1e-5));
    std::vector<glm::vec3> expected = a.state().radiosity;
    for (glm::vec3& e : expected) e *= 0x1p9f;
    EXPECT_TRUE(same_bits(b.state().radiosity, expected));
}

// RS-8: 1000 times the same 100 patches send small shots to one that is black; between, the host gives them back what they shot.
TEST_F(RadiositySolver, ManySmallShotsAddUp) {
    constexpr std::size_t kShooters = 100, kBatches = 1000;
    Room room = make_room(std::vector<double>(kShooters + 1, 0.75), 1);
    glm::dvec3 expected(0);
    for (std::size_t i = 0; i <= kShooters; ++i) {
        std::vector<double> row(kShooters + 1, 0);
        row.back() = 0x1p-12 * static_cast<double>(1 + i % 13);
        room.rows.push_back(to_units(row, row.back()));
        if (i < kShooters) room.emission[i] = {1 + 0.0371 * static_cast<double>(i), 1.0 / 3, 0.1};
        expected += double{kBatches} * row.back() * glm::dvec3(room.emission[i]);
    }
    room.emission.back() = {1000, 0, 0}; // shot once, and to nobody: the black one sees itself not
    room.rows.back().back() = 0;
    ProgressiveSolver solver = solver_of(room, kShooters + 1);
    for (std::size_t batch = 0; batch < kBatches; ++batch) {
        ASSERT_EQ(shoot_batch(device(), solver, room, kShooters + 1), kShooters + (batch == 0 ? 1 : 0));
        RadiosityState state = solver.state();
        for (std::size_t i = 0; i < kShooters; ++i) state.unshot[i] = room.emission[i];
        solver.set_state(state);
    }
    const RadiosityState state = solver.state();
    EXPECT_EQ(state.shots, kShooters * kBatches + 1);
    for (int c = 0; c < 3; ++c) {
        const double off = state.received.back()[c] / expected[c] - 1;
        EXPECT_LE(std::abs(off), 1e-6) << c;
        fmt::print("channel {}: off by {:.2g}\n", c, off);
    }
}

// The largest energies, exactly, whatever the number of patches; of equal ones the lowest number first.
TEST_F(RadiositySolver, ChoosesTheLargestInOrder) {
    constexpr std::size_t kPatches = 1500;
    Room room = make_room(std::vector<double>(2 * kPatches, 0.25), 2);
    for (std::size_t i = 0; i < room.size(); ++i) room.emission[i] = glm::vec3(static_cast<float>(i * 7919 % 101), 0, 1); // many are equal
    ProgressiveSolver solver = solver_of(room, 40);
    std::vector<std::pair<float, std::uint32_t>> order;
    for (const Patch& p : room.mesh.patches)
        order.emplace_back(-(room.emission[p.first].x + room.emission[p.first + 1].x), static_cast<std::uint32_t>(order.size()));
    std::ranges::sort(order);
    for (const unsigned most : {40u, 25u, 0u}) {
        gpu::Recorder recorder(device());
        solver.record_choice(recorder, most);
        recorder.submit_and_wait();
        const auto chosen = gpu::download_all<std::uint32_t>(device(), solver.chosen());
        for (unsigned k = 0; k < 40; ++k) EXPECT_EQ(chosen[k], k < most ? order[k].second : kNoElement) << k;
    }
}

TEST_F(RadiositySolver, GoesOnBitForBitWhereItWasLeft) {
    const Room room = random_room(90, 3, 0.9f, 9);
    ProgressiveSolver whole = solver_of(room, 5), first = solver_of(room, 5), second = solver_of(room, 5);
    for (int i = 0; i < 30; ++i) shoot_batch(device(), whole, room, 5);
    for (int i = 0; i < 13; ++i) shoot_batch(device(), first, room, 5);
    second.set_state(first.state());
    expect_same_bits(first.state(), second.state());
    EXPECT_EQ(first.ledger().unshot, second.ledger().unshot);
    for (int i = 13; i < 30; ++i) shoot_batch(device(), second, room, 5);
    expect_same_bits(whole.state(), second.state());
}

TEST_F(RadiositySolver, BatchesOfOneAndOfSixteenEndAlike) {
    const Room room = random_room(96, 4, 0.8f, 10);
    ProgressiveSolver one = solver_of(room, 1), sixteen = solver_of(room, 16);
    const unsigned few = shoot_until(device(), one, room, 1, 1e-6), many = shoot_until(device(), sixteen, room, 16, 1e-6);
    const std::vector<glm::vec3> b = one.state().radiosity;
    EXPECT_LE(largest_difference(sixteen.state().radiosity, {b.begin(), b.end()}), 1e-5);
    fmt::print("{} shots one by one, {} by sixteen\n", few, many);
}

TEST_F(RadiositySolver, ThreadsOfTheDriverChangeNothing) {
    const Room room = random_room(300, 3, 0.8f, 11);
    ProgressiveSolver solver = solver_of(room, 8);
    for (int i = 0; i < 5; ++i) shoot_batch(device(), solver, room, 8);
    gpu::Environment threads("LP_NUM_THREADS", "0");
    gpu::Device other = gpu::Device::open({.choice = "", .validation = true});
    ProgressiveSolver again(other, room.mesh, room.emission, room.reflectance, 8);
    for (int i = 0; i < 5; ++i) shoot_batch(other, again, room, 8);
    expect_same_bits(solver.state(), again.state());
}

TEST_F(RadiositySolver, CoveredElementsTakeNoPart) {
    Room room = random_room(24, 4, 0.8f, 12);
    room.mesh.elements[7].covered = true, room.emission[7] = glm::vec3(100);
    for (auto& row : room.rows) row[7] = 0;
    ProgressiveSolver solver = solver_of(room, 4);
    shoot_until(device(), solver, room, 4, 1e-6);
    EXPECT_EQ(solver.state().radiosity[7], glm::vec3(0));
    room.emission[7] = room.reflectance[7] = glm::vec3(0);
    EXPECT_LE(largest_difference(solver.state().radiosity, room.direct_solution()), 1e-5);
}

// More elements than a lane may visit: lavapipe ends loops after 65 535 rounds without a word.
TEST_F(RadiositySolver, PatchesOfVeryManyElements) {
    constexpr std::size_t kMany = 150'000;
    Room room = make_room(std::vector<double>(kMany, 0.5), kMany - 1);
    for (std::size_t i = 0; i < kMany; ++i) room.emission[i] = glm::vec3(1.0f + static_cast<float>(i % 5), 1, 0);
    ProgressiveSolver solver = solver_of(room, 1);
    const Ledger l = solver.ledger();
    EXPECT_NEAR(l.unshot.x / l.emitted.x, 1, 1e-6);
    EXPECT_NEAR(l.unshot.y / l.emitted.y, 1, 1e-6);
    room.rows.assign(2, std::vector<std::uint32_t>(kMany, gpu_layout::kHemicubeOne / kMany));
    shoot_batch(device(), solver, room, 1);
    const Ledger after = solver.ledger();
    for (int c = 0; c < 2; ++c) EXPECT_NEAR((after.absorbed[c] + after.unshot[c] + after.escaped[c]) / after.emitted[c], 1, 1e-5);
}

} // namespace
} // namespace lightbench
