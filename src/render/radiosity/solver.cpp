// Progressive refinement: its tables, its passes, its sums.
#include "render/radiosity/solver.h"

#include "gpu/check.h"
#include "render/gpu_scene.h"
#include "render/radiosity/solver_tables.h"
#include "render/shaders.h"
#include "shared/effects.h"
#include "shared/solve.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace lightbench {

using namespace gpu_layout;

struct SolverState {
    gpu::Device& device;
    std::uint32_t batch;
    std::vector<SolveElement> surfaces; // rho is 0 where an element is covered
    std::vector<glm::vec3> emission;    // and so is this
    std::vector<SolvePatch> ranges;
    double area = 0;
    glm::dvec3 emitted{0}, reflecting{0}; // sums of area times E, rho

    gpu::Buffer elements, patches, tally, shots, slots, chosen;
    std::array<gpu::Buffer, 2> states; // shots are read from one and written to the other
    unsigned now = 0;
    bool has_choice = false; // recorded and not shot yet
    gpu::ComputePipeline choose, sum_rows, shoot, sum_patches;
    bool rows_are_texels = false; // that sum_rows and shoot were made for

    glm::dvec3 escaped{0}; // and shots: up to the last set_state()
    std::uint64_t shots_before = 0;

    SolverState(gpu::Device& d, std::uint32_t batch_) : device(d), batch(batch_) {}
    std::uint32_t count() const { return static_cast<std::uint32_t>(surfaces.size()); }
    std::uint32_t patch_count() const { return static_cast<std::uint32_t>(ranges.size()); }
};

namespace {

// What a pass with a loop over patches or elements may take of the 65 535 rounds that lavapipe ends loops after, all loops together.
constexpr std::uint32_t kMostRounds = 60'000;

void take_surfaces(SolverState& s, const PatchMesh& mesh, std::span<const glm::vec3> emission, std::span<const glm::vec3> reflectance) {
    const std::size_t n = mesh.elements.size();
    CHECK(emission.size() == n);
    CHECK(reflectance.size() == n);
    s.surfaces.resize(n), s.emission.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Element& e = mesh.elements[i];
        const glm::vec3 rho = e.covered ? glm::vec3(0) : reflectance[i];
        CHECK(std::max({rho.x, rho.y, rho.z}) < 1.0f, "element {}", i);
        s.surfaces[i] = {rho, static_cast<float>(e.area), e.patch, 0, 0, 0};
        s.emission[i] = e.covered ? glm::vec3(0) : emission[i];
        if (e.covered) continue;
        s.area += e.area;
        s.emitted += e.area * glm::dvec3(s.emission[i]);
        s.reflecting += e.area * glm::dvec3(rho);
    }
    for (const Patch& patch : mesh.patches) s.ranges.push_back({patch.first, patch.count, 0, 0});
}

void make_buffers(SolverState& s) {
    const std::uint64_t bytes = std::uint64_t{s.count()} * sizeof(SolveState);
    if (bytes > s.device.info().max_storage_range)
        throw gpu::EnvironmentError(fmt::format("{} elements are more than {} can solve for: at most {}", s.count(), s.device.info().name,
                                                s.device.info().max_storage_range / sizeof(SolveState)));
    s.elements = make_table(s.device, "solve-elements", s.surfaces);
    s.patches = make_table(s.device, "solve-patches", s.ranges);
    s.tally = gpu::make_texel_buffer(s.device, "solve-tally", s.ranges.size() * sizeof(SolveTally));
    s.shots = gpu::make_texel_buffer(s.device, "solve-shots", s.batch * sizeof(SolveShot));
    s.slots = gpu::make_buffer(s.device, "solve-slots", s.batch * sizeof(SolveSlot), vk::BufferUsageFlagBits::eStorageBuffer);
    s.chosen = gpu::make_buffer(s.device, "chosen", s.batch * sizeof(std::uint32_t), vk::BufferUsageFlagBits::eStorageBuffer);
    for (gpu::Buffer& state : s.states) state = gpu::make_texel_buffer(s.device, "solve-state", bytes);
}

// One bit for all tables: as soon as one is too large, all are read as storage.
std::uint32_t table_bits(const SolverState& s) {
    const auto large = [](const gpu::Buffer* b) { return !b->as_texel(); };
    const std::array tables{&s.elements, &s.patches, &s.tally, &s.shots, &s.states[0]};
    return std::ranges::any_of(tables, large) ? FETCH_SOLVE_TABLES : 0u;
}

gpu::ComputePipeline make_pass(const SolverState& s, const char* shader, std::size_t push, std::uint32_t bits = 0) {
    return gpu::make_compute(s.device, find_shader(shader), {{CONSTANT_FETCH_STORAGE, table_bits(s) | bits}}, push);
}

// For rows as they come: whoever makes them knows how large they may be as texels.
void make_row_passes(SolverState& s, const gpu::Buffer& rows) {
    if (s.shoot && s.rows_are_texels == rows.as_texel()) return;
    const std::uint32_t bits = rows.as_texel() ? 0u : FETCH_SOLVE_ROWS;
    s.sum_rows = make_pass(s, "radiosity/solve_rows.comp", sizeof(ShootPush), bits);
    s.shoot = make_pass(s, "radiosity/solve_shoot.comp", sizeof(ShootPush), bits);
    s.rows_are_texels = rows.as_texel();
}

// So many lanes share a patch that each has rounds enough.
std::uint32_t lanes_of_patch(const SolverState& s) {
    const std::uint32_t largest = std::ranges::max(s.ranges, {}, &SolvePatch::count).count;
    const std::uint32_t lanes = std::bit_ceil((largest + kMostRounds - 1) / kMostRounds);
    CHECK(lanes <= kTallyLanes);
    return std::max(lanes, 1u);
}

void record_tally(SolverState& s, gpu::Recorder& recorder) {
    const TallyPush push{s.patch_count(), lanes_of_patch(s)};
    const std::uint32_t groups = (push.patches * push.lanes + kTallyLanes - 1) / kTallyLanes, wide = std::min(groups, 32768u);
    gpu::Bindings bindings{{"Tally", s.tally}};
    offer_table(bindings, "elements", s.elements);
    offer_table(bindings, "state", s.states[s.now]);
    offer_table(bindings, "patches", s.patches);
    recorder.compute("tally", s.sum_patches, bindings, push, {wide, (groups + wide - 1) / wide});
}

SolveState packed(glm::vec3 received, glm::vec3 received_carry, glm::vec3 unshot, glm::vec3 unshot_carry) {
    return {received, unshot.x, received_carry, unshot.y, unshot_carry, unshot.z};
}

// Only between submissions. What the tallies say of it is there at once.
void put_states(SolverState& s, const std::vector<SolveState>& states) {
    gpu::upload(s.device, s.states[s.now], std::as_bytes(std::span(states)));
    const std::vector<SolveSlot> slots(s.batch, SolveSlot{});
    gpu::upload(s.device, s.slots, std::as_bytes(std::span(slots)));
    s.has_choice = false;
    gpu::Recorder recorder(s.device);
    record_tally(s, recorder);
    recorder.submit_and_wait();
}

} // namespace

double Ledger::unshot_fraction() const {
    double largest = 0;
    for (int c = 0; c < 3; ++c)
        if (emitted[c] > 0) largest = std::max(largest, unshot[c] / emitted[c]);
    return largest;
}

ProgressiveSolver::ProgressiveSolver(gpu::Device& device, const PatchMesh& mesh, std::span<const glm::vec3> emission,
                                     std::span<const glm::vec3> reflectance, unsigned batch)
    : state_(std::make_unique<SolverState>(device, batch)) {
    SolverState& s = *state_;
    CHECK(mesh.elements.empty() == false);
    CHECK(batch > 0u);
    CHECK(std::uint64_t{batch} * mesh.elements.size() < (std::uint64_t{1} << 32));
    take_surfaces(s, mesh, emission, reflectance);
    make_buffers(s);
    s.choose = make_pass(s, "radiosity/solve_choose.comp", sizeof(ChoosePush));
    s.sum_patches = make_pass(s, "radiosity/solve_tally.comp", sizeof(TallyPush));
    restart();
}

ProgressiveSolver::ProgressiveSolver(ProgressiveSolver&&) noexcept = default;
ProgressiveSolver::~ProgressiveSolver() = default;

gpu::Buffer& ProgressiveSolver::unshot() {
    return state_->states[state_->now];
}

gpu::Buffer& ProgressiveSolver::chosen() {
    return state_->chosen;
}

// A lane of the pass looks through its patches once, and once more for each that it gives: where there are very many, fewer are chosen.
void ProgressiveSolver::record_choice(gpu::Recorder& recorder, unsigned most) {
    SolverState& s = *state_;
    const std::uint32_t rounds = s.patch_count() / kChooseLanes + 1;
    const ChoosePush push{s.patch_count(), s.batch, std::min(most, std::max(kMostRounds / rounds, 2u) - 1)};
    gpu::Bindings bindings{{"Chosen", s.chosen}, {"Shots", s.shots}};
    offer_table(bindings, "tally", s.tally);
    recorder.compute("choose", s.choose, bindings, push, {1});
    s.has_choice = true;
}

void ProgressiveSolver::record_shots(gpu::Recorder& recorder, gpu::Buffer& rows) {
    SolverState& s = *state_;
    CHECK(s.has_choice == true, "the patches of a choice shoot once");
    CHECK(rows.size() >= std::uint64_t{s.batch} * s.count() * sizeof(std::uint32_t));
    make_row_passes(s, rows);
    const ShootPush push{s.count(), s.batch};
    gpu::Bindings sums{{"Shots", s.shots}, {"Slots", s.slots}};
    offer_table(sums, "rows", rows);
    recorder.compute("sum-rows", s.sum_rows, sums, push, {s.batch});
    gpu::Bindings shots{{"After", s.states[1 - s.now]}};
    offer_table(shots, "elements", s.elements);
    offer_table(shots, "state", s.states[s.now]);
    offer_table(shots, "shots", s.shots);
    offer_table(shots, "rows", rows);
    recorder.compute("shoot", s.shoot, shots, push, {(s.count() + kShootLanes - 1) / kShootLanes});
    s.now = 1 - s.now;
    s.has_choice = false;
    record_tally(s, recorder);
}

Ledger ProgressiveSolver::ledger() {
    SolverState& s = *state_;
    Ledger ledger{.emitted = s.emitted, .absorbed = {}, .unshot = {}, .escaped = s.escaped};
    for (const SolveTally& t : read_table<SolveTally>(s.device, s.tally)) {
        ledger.absorbed += glm::dvec3(t.absorbed);
        ledger.unshot += glm::dvec3(t.unshot);
    }
    for (const SolveSlot& slot : read_table<SolveSlot>(s.device, s.slots))
        ledger.escaped += glm::dvec3(slot.escaped) + glm::dvec3(slot.escaped_carry);
    return ledger;
}

unsigned ProgressiveSolver::last_shots() {
    const auto chosen = gpu::download_all<std::uint32_t>(state_->device, state_->chosen);
    return static_cast<unsigned>(std::ranges::count_if(chosen, [](std::uint32_t patch) { return patch != kNoElement; }));
}

RadiosityState ProgressiveSolver::state() {
    SolverState& s = *state_;
    RadiosityState out;
    const auto states = read_table<SolveState>(s.device, s.states[s.now]);
    for (std::size_t i = 0; i < states.size(); ++i) {
        const SolveState& e = states[i];
        const glm::dvec3 received = glm::dvec3(e.received) + glm::dvec3(e.received_carry);
        out.radiosity.push_back(glm::vec3(glm::dvec3(s.emission[i]) + glm::dvec3(s.surfaces[i].reflectance) * received));
        out.unshot.push_back({e.unshot_r, e.unshot_g, e.unshot_b});
        out.received.push_back(e.received);
        out.unshot_carry.push_back(e.unshot_carry);
        out.received_carry.push_back(e.received_carry);
    }
    out.escaped = ledger().escaped;
    out.shots = s.shots_before;
    for (const SolveSlot& slot : read_table<SolveSlot>(s.device, s.slots)) out.shots += slot.shots;
    return out;
}

void ProgressiveSolver::set_state(const RadiosityState& state) {
    SolverState& s = *state_;
    CHECK(state.received.size() == s.surfaces.size());
    CHECK(state.unshot.size() == s.surfaces.size());
    const auto carry = [&](const std::vector<glm::vec3>& of, std::size_t i) { return of.empty() ? glm::vec3(0) : of.at(i); };
    std::vector<SolveState> states;
    for (std::size_t i = 0; i < s.surfaces.size(); ++i)
        states.push_back(packed(state.received[i], carry(state.received_carry, i), state.unshot[i], carry(state.unshot_carry, i)));
    s.escaped = state.escaped, s.shots_before = state.shots;
    put_states(s, states);
}

void ProgressiveSolver::restart() {
    SolverState& s = *state_;
    std::vector<SolveState> states;
    for (const glm::vec3& e : s.emission) states.push_back(packed({}, {}, e, {}));
    s.escaped = glm::dvec3(0), s.shots_before = 0;
    put_states(s, states);
}

// Cohen, Chen, Wallace and Greenberg 1988, "A Progressive Refinement Approach to Fast Radiosity Image Generation", sec. 5: what is unshot,
// as if every surface saw all others by their areas alone, and with all that it becomes by reflection.
glm::vec3 ProgressiveSolver::ambient() {
    const SolverState& s = *state_;
    if (s.area == 0) return glm::vec3(0);
    return glm::vec3(ledger().unshot / s.area / (1.0 - s.reflecting / s.area));
}

} // namespace lightbench
