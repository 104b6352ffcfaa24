// Gauss-Seidel on the full matrix, in blocks of rows: a dispatch a block, several sweeps a submission.
#include "gpu/check.h"
#include "render/gpu_scene.h"
#include "render/radiosity/solver.h"
#include "render/radiosity/solver_tables.h"
#include "render/shaders.h"
#include "shared/effects.h"
#include "shared/solve.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

using namespace gpu_layout;

constexpr unsigned kSweepsOfSubmission = 4; // a submission costs as much as two or three dispatches
constexpr unsigned kBlocks = 32;            // at most: the more, the fewer sweeps and the more dispatches
constexpr unsigned kSmallestBlock = 16;     // rows

struct FullState {
    gpu::Device& device;
    gpu::Buffer& matrix;
    std::uint32_t count;
    gpu::Buffer sums, surfaces;
    std::array<gpu::Buffer, 2> radiosity; // before a sweep and after it
    unsigned now = 0;
    gpu::ComputePipeline sum_rows, sweep;
};

void make_state(FullState& f, const PatchMesh& mesh, std::span<const glm::vec3> emission, std::span<const glm::vec3> reflectance) {
    std::vector<SolveSurface> surfaces;
    std::vector<SolveRadiosity> start;
    for (std::size_t i = 0; i < f.count; ++i) {
        const bool covered = mesh.elements[i].covered;
        const glm::vec3 e = covered ? glm::vec3(0) : emission[i], rho = covered ? glm::vec3(0) : reflectance[i];
        CHECK(std::max({rho.x, rho.y, rho.z}) < 1.0f, "element {}", i);
        surfaces.push_back({e, 0, rho, 0});
        start.push_back({e, 0});
    }
    f.sums = gpu::make_texel_buffer(f.device, "solve-sums", f.count * sizeof(SolveRowSum));
    f.surfaces = make_table(f.device, "solve-surfaces", surfaces);
    for (gpu::Buffer& b : f.radiosity) b = make_table(f.device, "solve-radiosity", start);
    const std::uint32_t bits = (f.surfaces.as_texel() ? 0u : FETCH_SOLVE_TABLES) | (f.matrix.as_texel() ? 0u : FETCH_SOLVE_ROWS);
    const gpu::Constants constants{{CONSTANT_FETCH_STORAGE, bits}};
    f.sum_rows = gpu::make_compute(f.device, find_shader("radiosity/solve_sums.comp"), constants, sizeof(SweepPush));
    f.sweep = gpu::make_compute(f.device, find_shader("radiosity/solve_sweep.comp"), constants, sizeof(SweepPush));
}

double sum_rows(FullState& f, const PatchMesh& mesh) {
    gpu::Recorder recorder(f.device);
    gpu::Bindings bindings{{"Sums", f.sums}};
    offer_table(bindings, "rows", f.matrix);
    recorder.compute("sum-rows", f.sum_rows, bindings, SweepPush{f.count, 0}, {f.count});
    recorder.submit_and_wait();
    double worst = 0;
    const auto sums = read_table<SolveRowSum>(f.device, f.sums);
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (!mesh.elements[i].covered) worst = std::max(worst, std::abs(1 - (sums[i].high * 65536.0 + sums[i].low) / kHemicubeOne));
    return worst;
}

void record_sweep(FullState& f, gpu::Recorder& recorder) {
    gpu::Buffer &before = f.radiosity[f.now], &after = f.radiosity[1 - f.now];
    gpu::Bindings bindings{{"After", after}};
    offer_table(bindings, "rows", f.matrix);
    offer_table(bindings, "before", before);
    offer_table(bindings, "done", after);
    offer_table(bindings, "sums", f.sums);
    offer_table(bindings, "surfaces", f.surfaces);
    const std::uint32_t block = std::max(kSmallestBlock, (f.count + kBlocks - 1) / kBlocks);
    for (std::uint32_t start = 0; start < f.count; start += block)
        recorder.compute("sweep", f.sweep, bindings, SweepPush{f.count, start}, {std::min(block, f.count - start)});
    f.now = 1 - f.now;
}

// The last sweep's largest change, relative to the largest radiosity.
double last_change(const std::vector<SolveRadiosity>& radiosity) {
    double change = 0, largest = 0;
    for (const SolveRadiosity& b : radiosity) {
        change = std::max<double>(change, b.change);
        largest = std::max<double>({largest, b.radiosity.x, b.radiosity.y, b.radiosity.z});
    }
    return largest > 0 ? change / largest : 0;
}

} // namespace

FullSolution solve_full(gpu::Device& device, const PatchMesh& mesh, gpu::Buffer& matrix, std::span<const glm::vec3> emission,
                        std::span<const glm::vec3> reflectance, double tolerance, unsigned most_sweeps) {
    const std::size_t n = mesh.elements.size();
    CHECK(n > 0u);
    CHECK(mesh.patches.size() == n);
    CHECK(emission.size() == n);
    CHECK(reflectance.size() == n);
    CHECK(n <= device.info().max_group_count); // and so n * n < 2^32
    CHECK(matrix.size() >= n * n * sizeof(std::uint32_t));
    FullState f{.device = device,
                .matrix = matrix,
                .count = static_cast<std::uint32_t>(n),
                .sums = {},
                .surfaces = {},
                .radiosity = {},
                .sum_rows = {},
                .sweep = {}};
    make_state(f, mesh, emission, reflectance);
    FullSolution solution;
    solution.closure_error = sum_rows(f, mesh);
    gpu::Recorder recorder(device);
    std::vector<SolveRadiosity> radiosity = read_table<SolveRadiosity>(device, f.radiosity[f.now]);
    for (double change = tolerance; solution.sweeps < most_sweeps && change >= tolerance; change = last_change(radiosity)) {
        const unsigned sweeps = std::min(kSweepsOfSubmission, most_sweeps - solution.sweeps);
        for (unsigned i = 0; i < sweeps; ++i) record_sweep(f, recorder);
        const gpu::Timings times = recorder.submit_and_wait();
        solution.times.insert(solution.times.end(), times.begin(), times.end());
        solution.sweeps += sweeps;
        radiosity = read_table<SolveRadiosity>(device, f.radiosity[f.now]);
    }
    for (const SolveRadiosity& b : radiosity) solution.radiosity.push_back(b.radiosity);
    return solution;
}

} // namespace lightbench
