// Tables, pipelines and the passes of hemi-cubes in their order.
#include "render/radiosity/hemicube.h"

#include "accel/accel.h"
#include "radiosity/form_factors.h"
#include "render/radiosity/hemicube_state.h"
#include "render/raster.h"
#include "render/ray_scene.h"
#include "render/shaders.h"

#include <algorithm>

namespace lightbench {
namespace {

using namespace gpu_layout;

template <class T> gpu::Buffer table(HemicubeState& s, const char* name, const std::vector<T>& values, std::uint32_t bit) {
    return hemicube_table(s, name, std::as_bytes(std::span(values)), bit);
}

void upload_structure(HemicubeState& s, RayPrimitives& primitives) {
    AccelTables accel = build_accel(primitives, {});
    s.stack = std::max(accel.stack, 2u), s.loose = accel.loose[0];
    if (primitives.triangles.size() > accel.loose[0]) s.loose |= 1u << 12;
    s.effects = RAY_TRIANGLES | (s.device.info().subgroup_size == 8 ? RAY_PACKETS : 0);
    prepend_planes(accel);
    if (accel.nodes.empty()) accel.nodes.resize(kWideTexels);
    s.nodes = table(s, "nodes", accel.nodes, FETCH_NODES);
    s.narrow = table(s, "narrow", accel.narrow, FETCH_NARROW);
    s.triangles = table(s, "triangles", primitives.triangles, FETCH_TRIANGLES);
}

void make_tables(HemicubeState& s, const HemicubeMesh& mesh) {
    s.receivers = table(s, "receivers", mesh.receivers, FETCH_RECEIVERS);
    s.shooters = table(s, "shooters", mesh.shooters, FETCH_SHOOTERS);
    std::vector<std::uint32_t> deltas = delta_form_factors(s.request.resolution);
    deltas.resize((deltas.size() + 3) / 4 * 4);
    s.deltas = table(s, "delta-form-factors", deltas, FETCH_HEMICUBE_DELTAS);
    const std::uint64_t batch = s.request.batch;
    s.views = empty_hemicube_table(s, "hemicube-views", batch * sizeof(HemicubeView), FETCH_HEMICUBE_VIEWS);
    s.items = empty_hemicube_table(s, "hemicube-items", (batch * s.face_items() * 4 + 15) / 16 * 16, FETCH_HEMICUBE_ITEMS);
    s.counters =
        gpu::make_buffer(s.device, "counters", sizeof(RayCounters), vk::BufferUsageFlagBits::eStorageBuffer, gpu::Memory::readback);
    const RayCounters none{};
    gpu::upload(s.device, s.counters, std::as_bytes(std::span(&none, 1)));
}

void make_pipelines(HemicubeState& s) {
    const auto make = [&](const char* shader, std::size_t push) {
        return gpu::make_compute(s.device, find_shader(shader), s.constants(), push);
    };
    s.view_pass = make("radiosity/hemicube_views.comp", sizeof(HemicubePush));
    if (s.request.way == HemicubeWay::rays) s.ray_pass = make("radiosity/hemicube_rays.comp", sizeof(RayPush));
    s.sum_pass = make("radiosity/hemicube_sum.comp", sizeof(HemicubePush));
}

void check_request(const HemicubeState& s, const PatchMesh& mesh) {
    CHECK(s.request.resolution % 2 == 0u, "hemi-cubes have an even number of pixels along an edge");
    CHECK(s.request.resolution >= 2u);
    CHECK(s.request.resolution <= 2048u, "pixels of a hemi-cube are counted in floats");
    CHECK(s.request.batch > 0u);
    CHECK(mesh.elements.empty() == false);
    CHECK(mesh.patches.empty() == false);
}

void record_rays(gpu::Recorder& recorder, HemicubeState& s) {
    gpu::Bindings bindings = s.with_structure({{"Items", s.items}, {"Counters", s.counters}});
    offer_table(bindings, "views", s.views);
    RayPush push{};
    push.triangle_count = static_cast<std::uint32_t>(s.triangles.size() / sizeof(RayTriangle));
    gpu::Groups groups = groups_for(s.face_items());
    groups.z = s.request.batch;
    recorder.compute("hemicube-rays", s.ray_pass, bindings, push, groups);
    s.expected += s.face_items() * s.request.batch;
}

void record_views(gpu::Recorder& recorder, HemicubeState& s, gpu::Buffer& chosen) {
    gpu::Bindings bindings{{"Chosen", chosen}, {"Views", s.views}};
    offer_table(bindings, "shooters", s.shooters);
    recorder.compute("hemicube-views", s.view_pass, bindings, HemicubePush{s.request.batch, s.elements, 0, 0, 0},
                     groups_for(s.request.batch));
}

void record_sum(gpu::Recorder& recorder, HemicubeState& s, gpu::Buffer& rows) {
    gpu::Bindings bindings{{"Counters", s.counters}, {"Rows", rows}};
    offer_table(bindings, "views", s.views);
    offer_table(bindings, "items", s.items);
    offer_table(bindings, "deltas", s.deltas);
    const std::uint32_t lines = 3 * s.request.resolution;
    gpu::Groups groups = groups_for(lines);
    groups.z = s.request.batch;
    recorder.compute("hemicube-sum", s.sum_pass, bindings, HemicubePush{lines, s.elements, 0, 0, 0}, groups);
    s.expected += lines * s.request.batch;
}

} // namespace

gpu::Buffer empty_hemicube_table(HemicubeState& s, const char* name, std::uint64_t bytes, std::uint32_t bit) {
    gpu::Buffer buffer = gpu::make_texel_buffer(s.device, name, bytes);
    if (!buffer.as_texel()) s.fetch_storage |= bit;
    return buffer;
}

gpu::Buffer hemicube_table(HemicubeState& s, const char* name, std::span<const std::byte> bytes, std::uint32_t bit) {
    gpu::Buffer buffer = empty_hemicube_table(s, name, bytes.size(), bit);
    gpu::upload(s.device, buffer, bytes);
    return buffer;
}

gpu::Constants HemicubeState::constants() const {
    return {{CONSTANT_FETCH_STORAGE, fetch_storage},
            {CONSTANT_RAY_EFFECTS, effects},
            {CONSTANT_ACCEL, ACCEL_BVH},
            {CONSTANT_STACK, stack},
            {CONSTANT_LOOSE, loose},
            {CONSTANT_RESOLUTION, request.resolution},
            {CONSTANT_NEAR_RAYS, request.near_rays},
            {CONSTANT_SHARES, request.shares ? 1u : 0u}};
}

gpu::Bindings HemicubeState::with_structure(gpu::Bindings bindings) {
    offer_table(bindings, "nodes", nodes);
    offer_table(bindings, "narrow", narrow);
    offer_table(bindings, "triangles", triangles);
    return bindings;
}

Hemicubes::Hemicubes(gpu::Device& device, const PatchMesh& mesh, const HemicubeRequest& request)
    : state_(new HemicubeState{.device = device, .request = request}) {
    HemicubeState& s = *state_;
    check_request(s, mesh);
    s.elements = static_cast<std::uint32_t>(mesh.elements.size()), s.patches = static_cast<std::uint32_t>(mesh.patches.size());
    HemicubeMesh made = hemicube_mesh(mesh);
    make_tables(s, made);
    if (s.traces()) upload_structure(s, made.primitives);
    if (request.correct_near) s.corners = table(s, "element-corners", made.corners, FETCH_ELEMENT_CORNERS);
    if (std::uint64_t{s.elements} * kSolveStateTexels > device.info().max_texel_elements) s.fetch_storage |= FETCH_UNSHOT;
    make_pipelines(s);
    if (request.way == HemicubeWay::raster) s.faces = make_faces(s, made);
    if (request.correct_near) make_near_passes(s);
}

Hemicubes::Hemicubes(Hemicubes&&) noexcept = default;
Hemicubes::~Hemicubes() = default;

gpu::Buffer& Hemicubes::receivers() {
    return state_->receivers;
}
gpu::Buffer& Hemicubes::shooters() {
    return state_->shooters;
}

gpu::Buffer Hemicubes::make_rows(const char* name) const {
    const std::uint64_t bytes = std::uint64_t{state_->request.batch} * state_->elements * sizeof(std::uint32_t);
    return gpu::make_texel_buffer(state_->device, name, (bytes + 15) / 16 * 16);
}

void Hemicubes::record(gpu::Recorder& recorder, gpu::Buffer& chosen, gpu::Buffer& rows, float near_sizes, gpu::Buffer* unshot) {
    HemicubeState& s = *state_;
    CHECK(chosen.size() >= s.request.batch * sizeof(std::uint32_t), "{}", chosen.name());
    CHECK(rows.size() >= std::uint64_t{s.request.batch} * s.elements * sizeof(std::uint32_t), "{}", rows.name());
    record_views(recorder, s, chosen);
    recorder.fill(rows, 0);
    s.request.way == HemicubeWay::rays ? record_rays(recorder, s) : record_faces(recorder, s);
    record_sum(recorder, s, rows);
    if (s.request.correct_near) record_near(recorder, s, rows, near_sizes, unshot);
}

void Hemicubes::check() {
    HemicubeState& s = *state_;
    RayCounters c{};
    gpu::download(s.device, s.counters, std::as_writable_bytes(std::span(&c, 1)));
    CHECK(c.done == s.expected, "in hemi-cubes: the driver left out invocations");
    if (c.unfinished > 0)
        throw gpu::EnvironmentError(
            fmt::format("{} rays of hemi-cubes did not come to an end within the steps that the device grants a dispatch: raise --element",
                        c.unfinished));
}

std::vector<std::uint32_t> Hemicubes::items(unsigned index) {
    HemicubeState& s = *state_;
    CHECK(index < s.request.batch);
    std::vector<std::uint32_t> items(s.face_items());
    gpu::download(s.device, s.items, std::as_writable_bytes(std::span(items)), std::uint64_t{index} * s.face_items() * 4);
    return items;
}

} // namespace lightbench
