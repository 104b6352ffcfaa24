#include "render/radiosity/radiosity.h"

#include "gpu/errors.h"
#include "image/file_bytes.h"
#include "radiosity/reconstruct.h"
#include "render/radiosity/draw.h"
#include "render/radiosity/feed.h"
#include "render/radiosity/hemicube.h"
#include "render/radiosity/reflectance.h"
#include "render/radiosity/show.h"
#include "scene/limits.h"

#include <algorithm>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <numeric>
#include <utility>

namespace lightbench {

constexpr unsigned kNearRays = 16;

// Drawing costs what there is to draw, rays cost pixels: 0.75 us an element and 0.21 us a ray on lavapipe 22.3.6, 2 cores
// (tests/bench/hemicube_bench.cpp). --stats tells which it was by the names of passes.
HemicubeWay cheaper_way(std::size_t elements, unsigned resolution) {
    constexpr double kRaysAnElement = 0.75 / 0.21;
    return kRaysAnElement * double(elements) < 3.0 * resolution * resolution ? HemicubeWay::raster : HemicubeWay::rays;
}

struct RadiosityParts {
    gpu::Device& device;
    RadiosityParameters parameters;
    PatchMesh mesh;
    SurfaceLight light;
    std::optional<Hemicubes> hemicubes{};
    std::optional<ProgressiveSolver> solver{};
    gpu::Buffer rows{};
    std::optional<FullSolution> full{};
    RadiosityStatistics statistics{};
    std::uint64_t sources = 0; // patches that glow by themselves
    gpu::Timings feed_times{}; // until a run tells of them
    ElementDrawing drawing{};

    // What is near a patch is told of what each of its elements has to shoot.
    bool shares() const { return parameters.correct_near && parameters.solver == Solver::progressive && parameters.show == Show::light; }
    gpu::Buffer* unshot() { return shares() ? &solver->unshot() : nullptr; }
};

namespace {

constexpr unsigned kBatch = 16; // hemi-cubes a submission

// A lamp's light is most of what there is, and its shadows are seen: all that it shines on gets analytic form factors, by so many rays to it.
// Later shots are many and weak: only what lies beside them. To five sizes (kNearSizes) the corrections of the Cornell box took 128 s of 152.
constexpr float kFirstNear = 1e6f, kLaterNear = 1.0f;

PatchRequest patches_for(const RadiosityParameters& p) {
    PatchRequest request;
    const bool full = p.solver == Solver::full;
    request.patch = full ? std::numeric_limits<double>::min() : p.patch; // no smaller than an element: each is a patch
    request.element = full ? p.patch : p.element > 0 ? p.element : p.patch / 4;
    if (full && p.patch == 0) request.elements = 2000;
    return request;
}

PatchMesh mesh_for(const Scene& scene, const RadiosityParameters& p) {
    try {
        PatchMesh mesh = make_patches(scene, patches_for(p));
        if (p.solver == Solver::full) make_elements_patches(mesh);
        return mesh;
    } catch (const std::length_error&) {
        throw FileError(FileError::Blame::Input,
                        fmt::format("--patch: the scene would have more than {} elements; choose a larger one", limits::kMaxElements));
    }
}

// Of what a solution depends on.
std::uint64_t key_of(const RadiosityParts& parts) {
    std::uint64_t key = hash_bytes({});
    const auto add = [&](const auto& value) { key = hash_bytes(std::as_bytes(std::span(&value, 1)), key); };
    for (const glm::dvec3& p : parts.mesh.points) add(p);
    for (const Element& e : parts.mesh.elements) add(e.corners), add(e.patch), add(e.covered);
    for (std::size_t i = 0; i < parts.mesh.elements.size(); ++i) add(parts.light.emission[i]), add(parts.light.reflectance[i]);
    add(parts.parameters.hemicube), add(parts.parameters.correct_near), add(parts.mesh.frame.scale);
    return key;
}

double milliseconds_of(const gpu::Timings& times) {
    double sum = 0;
    for (const gpu::PassTime& t : times) sum += t.milliseconds;
    return sum;
}

void note_progress(RadiosityParts& p, const gpu::Timings& times) {
    RadiosityStatistics& s = p.statistics;
    s.milliseconds += milliseconds_of(times);
    s.unshot = p.solver->ledger().unshot_fraction();
    s.curve.push_back({s.shots, s.unshot, s.milliseconds});
}

void append(gpu::Timings& to, const gpu::Timings& from) {
    to.insert(to.end(), from.begin(), from.end());
}

bool shoot(RadiosityParts& p, gpu::Recorder& recorder, gpu::Timings& times) {
    RadiosityStatistics& s = p.statistics;
    const std::uint64_t left = p.parameters.shots ? *p.parameters.shots - std::min<std::uint64_t>(s.shots, *p.parameters.shots) : kBatch;
    if (left == 0 || s.unshot <= p.parameters.until) return false;
    p.solver->record_choice(recorder, static_cast<unsigned>(std::min<std::uint64_t>(left, kBatch)));
    p.hemicubes->record(recorder, p.solver->chosen(), p.rows, s.shots < p.sources ? kFirstNear : kLaterNear, p.unshot());
    p.solver->record_shots(recorder, p.rows);
    const gpu::Timings now = recorder.submit_and_wait();
    append(times, now);
    p.hemicubes->check();
    const unsigned shot = p.solver->last_shots();
    s.shots += shot;
    note_progress(p, now);
    return shot > 0;
}

// A submission's worth of numbers: those given, and none.
gpu::Buffer chosen_patches(RadiosityParts& p, std::span<const std::uint32_t> numbers) {
    std::array<std::uint32_t, kBatch> ids{};
    ids.fill(kNoElement);
    std::ranges::copy(numbers, ids.begin());
    gpu::Buffer chosen = gpu::make_texel_buffer(p.device, "chosen", sizeof(ids));
    gpu::upload(p.device, chosen, std::as_bytes(std::span(ids)));
    return chosen;
}

// Row after row, as many at once as a submission holds.
gpu::Buffer full_matrix(RadiosityParts& p, gpu::Recorder& recorder, gpu::Timings& times) {
    const std::size_t n = p.mesh.elements.size();
    const std::uint64_t row = 4 * n, bytes = row * n;
    if (bytes > p.device.info().max_storage_range)
        throw gpu::EnvironmentError(
            fmt::format("the full matrix of {} elements takes {} MiB, more than a buffer of {} may have: choose a larger --patch, or "
                        "--solver progressive",
                        n, bytes >> 20, p.device.info().name));
    gpu::Buffer matrix = gpu::make_texel_buffer(p.device, "form-factors", (bytes + 15) / 16 * 16);
    for (std::uint32_t first = 0; first < n; first += kBatch) {
        std::vector<std::uint32_t> numbers(std::min<std::size_t>(kBatch, n - first));
        std::iota(numbers.begin(), numbers.end(), first);
        gpu::Buffer chosen = chosen_patches(p, numbers);
        p.hemicubes->record(recorder, chosen, p.rows, kLaterNear);
        recorder.copy(p.rows, matrix, row * std::min<std::uint64_t>(kBatch, n - first), 0, row * first);
        const gpu::Timings now = recorder.submit_and_wait();
        append(times, now);
        p.hemicubes->check();
        p.statistics.milliseconds += milliseconds_of(now);
    }
    return matrix;
}

bool solve_at_once(RadiosityParts& p, gpu::Recorder& recorder, gpu::Timings& times) {
    if (p.full) return false;
    gpu::Buffer matrix = full_matrix(p, recorder, times);
    p.full = solve_full(p.device, p.mesh, matrix, p.light.emission, p.light.reflectance, 1e-6, 20000);
    append(times, p.full->times);
    p.statistics.milliseconds += milliseconds_of(p.full->times);
    p.statistics.shots = p.full->sweeps, p.statistics.closure_error = p.full->closure_error, p.statistics.unshot = 0;
    return true;
}

} // namespace

Radiosity::Radiosity(gpu::Device& device, const Scene& scene, const Plan& plan, GpuScene& gpu_scene)
    : parts_(new RadiosityParts{device, plan.radiosity, mesh_for(scene, plan.radiosity), {}}) {
    RadiosityParts& p = *parts_;
    p.light = surface_light(scene, p.mesh);
    p.statistics.elements = p.mesh.elements.size(), p.statistics.patches = p.mesh.patches.size();
    p.drawing = make_drawing(device, p.mesh, plan.multisamples, p.parameters.show != Show::light);
    if (p.mesh.elements.empty() || p.parameters.show == Show::patches) return;
    p.hemicubes.emplace(device, p.mesh,
                        HemicubeRequest{p.parameters.hemicube, kBatch, cheaper_way(p.mesh.elements.size(), p.parameters.hemicube),
                                        p.parameters.correct_near, kNearRays, p.shares()});
    p.rows = p.hemicubes->make_rows();
    if (p.parameters.show != Show::light) return;
    for (const Patch& patch : p.mesh.patches) p.sources += p.light.emission[patch.first] != glm::vec3(0);
    if (plan.runs("feed")) {
        gpu::Recorder recorder(device);
        const auto fed = feed(device, recorder, *p.hemicubes, p.mesh.elements.size(), plan, gpu_scene, p.feed_times);
        for (std::size_t i = 0; i < fed.size(); ++i) p.light.emission[i] += p.light.reflectance[i] * fed[i];
    }
    if (p.parameters.solver == Solver::progressive) {
        p.solver.emplace(device, p.mesh, p.light.emission, p.light.reflectance, kBatch);
        p.statistics.unshot = p.solver->ledger().unshot_fraction();
    }
}

Radiosity::Radiosity(Radiosity&&) noexcept = default;
Radiosity::~Radiosity() = default;

void Radiosity::resume(const RadiositySolution& solution, const std::string& name) {
    RadiosityParts& p = *parts_;
    if (!p.solver || solution.key != key_of(p) || solution.state.radiosity.size() != p.mesh.elements.size())
        throw FileError(FileError::Blame::Input, fmt::format("{}: is the solution of another scene or of other parameters", name));
    p.solver->set_state(solution.state);
    p.statistics.shots = solution.state.shots, p.statistics.unshot = p.solver->ledger().unshot_fraction();
}

void Radiosity::restart() {
    RadiosityParts& p = *parts_;
    p.full.reset();
    const RadiosityStatistics before = std::exchange(p.statistics, {});
    p.statistics.patches = before.patches, p.statistics.elements = before.elements;
    if (!p.solver) return;
    p.solver->restart();
    p.statistics.unshot = p.solver->ledger().unshot_fraction();
}

RadiositySolution Radiosity::solution() {
    RadiositySolution solution{key_of(*parts_), parts_->solver->state()};
    solution.state.shots = parts_->statistics.shots;
    return solution;
}

bool Radiosity::advance(gpu::Recorder& recorder, gpu::Timings& times) {
    append(times, std::exchange(parts_->feed_times, {}));
    if (parts_->mesh.elements.empty()) return false;
    return parts_->solver ? shoot(*parts_, recorder, times) : solve_at_once(*parts_, recorder, times);
}

const RadiosityStatistics& Radiosity::statistics() const {
    return parts_->statistics;
}

std::optional<ImageF> Radiosity::show(gpu::Recorder& recorder, gpu::Timings& times, const View& view, glm::uvec2 size) {
    RadiosityParts& p = *parts_;
    const auto element = p.parameters.pick ? element_at(p.mesh, view, glm::dvec2(*p.parameters.pick) + 0.5) : std::nullopt;
    const auto patch = element ? std::optional(p.mesh.elements[*element].patch) : std::nullopt;
    if (p.parameters.pick && !patch)
        throw FileError(FileError::Blame::Input,
                        fmt::format("--pick: no surface is seen at pixel {},{}", p.parameters.pick->x, p.parameters.pick->y));
    std::vector<glm::vec3> colors = patch_colors(p.mesh, patch);
    if (p.parameters.show != Show::patches) {
        gpu::Buffer chosen = chosen_patches(p, {&*patch, 1});
        p.hemicubes->record(recorder, chosen, p.rows, kLaterNear);
        append(times, recorder.submit_and_wait());
        p.hemicubes->check();
        if (p.parameters.show == Show::hemicube) return unfold(p.hemicubes->items(0), p.parameters.hemicube, colors, size);
        colors = form_factor_colors(p.mesh, gpu::download_all<std::uint32_t>(p.device, p.rows), *patch);
    }
    std::vector<std::array<glm::vec3, 4>> corners;
    for (const glm::vec3& color : colors) corners.push_back({color, color, color, color});
    set_colors(p.device, p.drawing, corners);
    return std::nullopt;
}

// S31, S32: B / pi, and in place of what is unshot its estimate.
void Radiosity::update_colors() {
    RadiosityParts& p = *parts_;
    if (p.mesh.elements.empty()) return;
    std::vector<glm::vec3> radiance = p.solver ? p.solver->state().radiosity : p.full ? p.full->radiosity : p.light.emission;
    const glm::vec3 ambient = p.parameters.ambient && p.solver ? p.solver->ambient() : glm::vec3(0);
    for (std::size_t i = 0; i < radiance.size(); ++i) radiance[i] = (radiance[i] + p.light.reflectance[i] * ambient) / glm::pi<float>();
    set_colors(p.device, p.drawing, corner_values(p.mesh, radiance));
}

std::size_t Radiosity::record_draw(gpu::Recorder& recorder, const RasterDraw& draw, gpu::RenderTargets targets) {
    return record_elements(recorder, parts_->drawing, draw, parts_->mesh.frame, std::move(targets));
}

} // namespace lightbench
