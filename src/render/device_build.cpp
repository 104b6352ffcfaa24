// The passes of a build, in order; one submit up to the number of nodes, which tables are as large as, and one for the tables.
#include "render/device_build.h"

#include "accel/tables.h"

#include "gpu/check.h"
#include "gpu/errors.h"
#include "render/device_tables.h"
#include "shared/effects.h"

#include <algorithm>
#include <bit>
#include <chrono>

namespace lightbench {

using namespace gpu_layout;

namespace {

constexpr std::uint32_t kMostBoxLanes = 1024; // of the pass over boxes: six atomics each
constexpr std::uint32_t kMostLeaf = 4;        // as a reference counts them

// What src/accel/boxes.cpp pads by, and 24 * 2^-24 * 6 / 6 more: the sums in boxes.comp are of numbers below 4, so each is rounded by 2^-23
// at most, and there are two.
float padding_of(const RayPrimitives& primitives) {
    return std::nextafter(static_cast<float>(error_of_rays(primitives) * 1.0625), INFINITY);
}

std::array<std::size_t, 3> counts_of(const RayPrimitives& p) {
    return {p.triangles.size(), p.spheres.size(), p.shapes.size()};
}

// Of each type in the tree.
std::array<std::uint32_t, 3> counts_in_tree(const RayPrimitives& primitives) {
    const auto counts = counts_of(primitives);
    const auto loose = loose_types(counts);
    std::array<std::uint32_t, 3> in_tree{};
    for (std::size_t type = 0; type < 3; ++type) in_tree[type] = loose[type] > 0 ? 0 : static_cast<std::uint32_t>(counts[type]);
    return in_tree;
}

// Boxes of shapes need double precision: the host makes them. Texels (low, 0), (high, 0).
std::vector<uvec4> shape_boxes(const RayPrimitives& all) {
    RayPrimitives shapes;
    shapes.shapes = all.shapes, shapes.reach = all.reach;
    for (std::uint32_t i = 0; i < shapes.shapes.size(); ++i) shapes.shapes[i].number = i;
    std::vector<uvec4> texels;
    for (const FloatBox& box : boxes_of(shapes))
        for (const glm::vec3& p : {box.min, box.max}) texels.emplace_back(glm::floatBitsToUint(p), 0u);
    return texels;
}

} // namespace

struct DeviceBuilder::State {
    explicit State(gpu::Device& d) : device(d), recorder(d), pipelines(d), sort(d) {}
    gpu::Device& device;
    gpu::Recorder recorder;
    BuildPipelines pipelines;
    DeviceSort sort;
    BuildScratch scratch;
    void fit(const RayPrimitives& primitives);
};

namespace {

class Build {
  public:
    Build(gpu::Device& device, gpu::Recorder& recorder, BuildPipelines& pipelines, DeviceSort& sort, BuildScratch& scratch,
          const RayPrimitives& primitives, std::uint32_t leaf)
        : device_(device), recorder_(recorder), pipelines_(pipelines), sort_(sort), scratch_(scratch), primitives_(primitives) {
        const auto counts = counts_in_tree(primitives);
        for (std::size_t type = 0; type < 3; ++type) types_ |= counts[type] > 0 ? 1u << type : 0u;
        push_.items = counts[0] + counts[1] + counts[2];
        push_.triangles = counts[0], push_.spheres = counts[1];
        push_.leaves = std::bit_ceil(push_.items);
        push_.leaf = leaf;
        push_.pad = padding_of(primitives);
        inner_ = push_.items - 1;
    }

    DeviceTree run();

  private:
    bool many_types() const { return !std::has_single_bit(types_); }
    void upload_primitives();
    void record_codes();
    void record_pyramid();
    void record_hierarchy();
    void make_tables();
    void record_tables();
    void record_order(std::uint32_t type, gpu::Buffer& table, std::uint32_t texels, std::uint32_t count);
    void submit();
    void pass(const char* shader, gpu::Bindings bindings, std::uint32_t count, std::uint32_t texels = 0);

    gpu::Device& device_;
    gpu::Recorder& recorder_;
    BuildPipelines& pipelines_;
    DeviceSort& sort_;
    BuildScratch& scratch_;
    const RayPrimitives& primitives_;
    BuildPush push_{};
    std::uint32_t types_ = 0, inner_ = 0, kept_ = 0;
    DeviceTree out_;
};

void Build::pass(const char* shader, gpu::Bindings bindings, std::uint32_t count, std::uint32_t texels) {
    push_.count = count;
    recorder_.compute(shader, pipelines_.of(shader, types_, texels), bindings, push_, build_groups(device_, count));
}

void Build::submit() {
    const auto times = recorder_.submit_and_wait();
    out_.times.insert(out_.times.end(), times.begin(), times.end());
}

void Build::upload_primitives() {
    out_.triangles = filled_table(device_, "triangles", primitives_.triangles);
    out_.spheres = filled_table(device_, "spheres", primitives_.spheres);
    out_.shapes = filled_table(device_, "shapes", primitives_.shapes);
    scratch_.shape_boxes = types_ & 4u ? filled_table(device_, "shape-boxes", shape_boxes(primitives_)) : gpu::Buffer{};
}

void Build::record_codes() {
    recorder_.fill(scratch_.bounds, ~0u);
    gpu::Bindings boxes{{"Boxes", scratch_.boxes}, {"Bounds", scratch_.bounds}};
    if (types_ & 1u) offer_table(boxes, "triangles", out_.triangles);
    if (types_ & 2u) offer_table(boxes, "spheres", out_.spheres);
    if (types_ & 4u) offer_table(boxes, "shape_boxes", scratch_.shape_boxes);
    pass("accel/boxes.comp", std::move(boxes), std::min(push_.items, kMostBoxLanes));
    gpu::Bindings codes{{"Bounds", scratch_.bounds}, {"Keys", scratch_.keys}};
    offer_table(codes, "boxes", scratch_.boxes);
    pass("accel/codes.comp", std::move(codes), push_.items);
    sort_.sort(recorder_, scratch_.keys, scratch_.order, push_.items);
}

void Build::record_pyramid() {
    gpu::Bindings base{{"Pyramid", scratch_.pyramid}, {"Types", scratch_.types}};
    offer_table(base, "boxes", scratch_.boxes);
    offer_table(base, "order", scratch_.order);
    pass("accel/pyramid_base.comp", std::move(base), push_.leaves);
    if (many_types()) sort_.part(recorder_, scratch_.types, &scratch_.order, scratch_.type_order, scratch_.ranks, push_.items);
    for (std::uint32_t level = push_.leaves; level > 1; level = push_.first) {
        push_.levels = std::min(3u, static_cast<std::uint32_t>(std::countr_zero(level)));
        push_.first = level >> push_.levels;
        gpu::Bindings above{{"Pyramid", scratch_.pyramid}};
        offer_table(above, "pyramid", scratch_.pyramid);
        pass("accel/pyramid.comp", std::move(above), push_.first);
    }
}

void Build::record_hierarchy() {
    gpu::Bindings hierarchy{{"Ranges", scratch_.ranges}, {"Flags", scratch_.flags}};
    offer_table(hierarchy, "keys", scratch_.keys);
    offer_table(hierarchy, "types", scratch_.types);
    pass("accel/hierarchy.comp", std::move(hierarchy), inner_);
    sort_.part(recorder_, scratch_.flags, nullptr, scratch_.node_order, scratch_.node_ranks, inner_);
}

// Once it is known how many nodes stay, and what box is about all of them.
void Build::make_tables() {
    kept_ = sort_.zeros(device_);
    CHECK(kept_ > 0u, "while building a tree on the device");
    CHECK(kept_ <= inner_, "while building a tree on the device");
    std::array<glm::vec4, 2> box;
    gpu::download(device_, scratch_.pyramid, std::as_writable_bytes(std::span(box)), 16 * std::size_t{kBoxTexels});
    const double margin = set_planes(out_.accel, {glm::vec3(box[0]), glm::vec3(box[1])});
    for (int axis = 0; axis < 3; ++axis) {
        const double step = double{out_.accel.narrow_step[axis]};
        push_.origin[axis] = out_.accel.narrow_origin[axis];
        push_.per_step[axis] = static_cast<float>(1 / step);
        push_.margin[axis] = static_cast<float>(margin / step) + 1.0f / 32;
    }
    out_.nodes = make_table(device_, "nodes", std::size_t{kept_} * kWideTexels);
    out_.narrow = make_table(device_, "narrow", std::size_t{kept_} * kNarrowTexels + 2);
    const auto words = [](const glm::vec3& v) { return uvec4(glm::floatBitsToUint(v), 0); };
    const std::array<uvec4, 2> planes{words(out_.accel.narrow_origin), words(out_.accel.narrow_step)};
    gpu::upload(device_, out_.narrow, std::as_bytes(std::span(planes)));
    scratch_.fit_nodes(device_, kept_);
}

void Build::record_tables() {
    gpu::Bindings nodes{{"Nodes", scratch_.nodes}, {"Narrow", out_.narrow}, {"Parents", scratch_.parents}};
    offer_table(nodes, "pyramid", scratch_.pyramid);
    offer_table(nodes, "order", scratch_.node_order);
    offer_table(nodes, "numbers", scratch_.node_ranks);
    offer_table(nodes, "ranges", scratch_.ranges);
    offer_table(nodes, "types", scratch_.types);
    offer_table(nodes, "ranks", scratch_.ranks);
    pass("accel/nodes.comp", std::move(nodes), kept_);
    gpu::Bindings depth{{"Bounds", scratch_.bounds}};
    offer_table(depth, "nodes", scratch_.nodes);
    offer_table(depth, "parents", scratch_.parents);
    pass("accel/depth.comp", std::move(depth), kept_);
    gpu::Bindings wide{{"Wide", out_.nodes}};
    offer_table(wide, "nodes", scratch_.nodes);
    pass("accel/wide.comp", std::move(wide), kept_);
    push_.first = 0;
    if (types_ & 1u) record_order(0, out_.triangles, kTriangleTexels, push_.triangles);
    push_.first = push_.triangles;
    if (types_ & 2u) record_order(1, out_.spheres, kSphereTexels, push_.spheres);
    push_.first += push_.spheres;
    if (types_ & 4u) record_order(2, out_.shapes, kShapeTexels, push_.items - push_.first);
}

void Build::record_order(std::uint32_t type, gpu::Buffer& table, std::uint32_t texels, std::uint32_t count) {
    gpu::Buffer& ordered = scratch_.unordered[type]; // until the two are exchanged
    ordered = make_table(device_, table.name().c_str(), std::size_t{count} * texels);
    gpu::Bindings bindings{{"Ordered", ordered}};
    offer_table(bindings, "order", many_types() ? scratch_.type_order : scratch_.order);
    offer_table(bindings, "table", table);
    pass("accel/reorder.comp", std::move(bindings), count, texels);
    std::swap(table, ordered);
}

DeviceTree Build::run() {
    upload_primitives();
    record_codes();
    record_pyramid();
    record_hierarchy();
    submit();
    make_tables();
    record_tables();
    submit();
    for (gpu::Buffer& buffer : scratch_.unordered) buffer = {};
    BuildBounds bounds{};
    gpu::download(device_, scratch_.bounds, std::as_writable_bytes(std::span(&bounds, 1)));
    AccelTables& accel = out_.accel;
    accel.depth = ~bounds.deepest;
    CHECK(accel.depth <= 64u, "while building a tree on the device");
    // As accel/bvh_wide.cpp and bvh_narrow.cpp count; each level of the wide tree is two of the other and leaves three children waiting.
    accel.stack = std::max(accel.depth + 2, 3 * ((accel.depth + 1) / 2) + 3);
    accel.loose = loose_types(counts_of(primitives_));
    accel.node_count = kept_, accel.reference_count = push_.items;
    return std::move(out_);
}

} // namespace

void DeviceBuilder::State::fit(const RayPrimitives& primitives) {
    const auto counts = counts_in_tree(primitives);
    const std::uint32_t items = counts[0] + counts[1] + counts[2];
    if (items > scratch.items) {
        scratch = {};
        scratch.fit_items(device, items);
        sort.fit(items, !scratch.all_texel());
    }
    pipelines.set_storage(!scratch.all_texel() || !device.fits_texel_buffer(primitives.shapes.size() * sizeof(RayShape)));
}

DeviceBuilder::DeviceBuilder(gpu::Device& device) : state_(std::make_unique<State>(device)) {}
DeviceBuilder::DeviceBuilder(DeviceBuilder&&) noexcept = default;
DeviceBuilder::~DeviceBuilder() = default;

void DeviceBuilder::warm_up(const RayPrimitives& primitives) {
    constexpr std::uint32_t kFew = 13; // lavapipe compiles anew where a size is a power of two: this makes none of one
    const auto counts = counts_in_tree(primitives);
    RayPrimitives few;
    few.triangles.assign(primitives.triangles.begin(), primitives.triangles.begin() + std::min(counts[0], kFew));
    few.spheres.assign(primitives.spheres.begin(), primitives.spheres.begin() + std::min(counts[1], kFew));
    few.shapes.assign(primitives.shapes.begin(), primitives.shapes.begin() + std::min(counts[2], kFew));
    state_->fit(primitives);
    build(few, 1);
}

DeviceTree DeviceBuilder::build(const RayPrimitives& primitives, std::uint32_t leaf) {
    const auto start = std::chrono::steady_clock::now();
    CHECK(has_tree(primitives), "a tree needs two primitives");
    State& s = *state_;
    s.fit(primitives);
    const std::uint32_t most = std::clamp(leaf == 0 ? kMostLeaf : leaf, 1u, kMostLeaf);
    DeviceTree tree = Build(s.device, s.recorder, s.pipelines, s.sort, s.scratch, primitives, most).run();
    tree.accel.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return tree;
}

bool has_tree(const RayPrimitives& primitives) {
    const auto counts = counts_in_tree(primitives);
    return counts[0] + counts[1] + counts[2] >= 2;
}

} // namespace lightbench
