#include "render/device_sort.h"

#include "render/gpu_scene.h"
#include "render/shaders.h"
#include "shared/build.h"
#include "shared/effects.h"

#include <algorithm>

namespace lightbench {

using namespace gpu_layout;

namespace {

// Of a pass at most: its counts take 1 MiB, and a CPU driver has enough of them to share among its threads.
constexpr std::uint32_t kMostLanes = 1024;
constexpr std::uint32_t kLeastChunk = 256; // elements of a lane: fewer, and most of the time goes into the counts
constexpr std::uint32_t kFewDigits = 4;

} // namespace

struct DeviceSort::Cut {
    std::uint32_t count = 0, chunk = 0, lanes = 0;
};

DeviceSort::Cut DeviceSort::cut(std::uint32_t count) {
    const std::uint32_t chunk = (std::max(kLeastChunk, (count + kMostLanes - 1) / kMostLanes) + 3) / 4 * 4;
    const std::uint32_t lanes = std::max((count + chunk - 1) / chunk, 1u);
    return {count, chunk, (lanes + 63) / 64 * 64};
}

gpu::Buffer make_words(gpu::Device& device, const char* name, std::size_t words) {
    return gpu::make_texel_buffer(device, name, std::max<std::size_t>((words + 3) / 4, 1) * 16);
}

void DeviceSort::fit(std::uint32_t most, bool storage) {
    if (storage != storage_) pipelines_.clear();
    storage_ = storage;
    keys_ = make_words(device_, "sort-keys", most), order_ = make_words(device_, "sort-order", most);
    const std::size_t counts = std::size_t{kSortDigits} * kMostLanes;
    counts_ = make_words(device_, "sort-counts", counts), offsets_ = make_words(device_, "sort-offsets", counts);
}

const gpu::ComputePipeline& DeviceSort::pipeline(Kind kind, std::uint32_t digits, std::uint32_t moves) {
    static constexpr const char* kShaders[] = {"accel/sort_count.comp", "accel/sort_scan.comp", "accel/sort_move.comp"};
    gpu::ComputePipeline& made = pipelines_[{kind, digits, moves}];
    if (made) return made;
    const gpu::Constants constants{
        {CONSTANT_FETCH_STORAGE, storage_ ? FETCH_BUILD : 0u}, {CONSTANT_SORT_DIGITS, digits}, {CONSTANT_SORT_MOVE, moves}};
    made = gpu::make_compute(device_, find_shader(kShaders[static_cast<std::size_t>(kind)]), constants, sizeof(SortPush));
    return made;
}

// `bindings`: what the moving reads and writes.
void DeviceSort::pass(gpu::Recorder& recorder, const Cut& cut, std::uint32_t shift, std::uint32_t digits, std::uint32_t moves,
                      gpu::Bindings bindings) {
    const SortPush push{cut.count, cut.chunk, cut.lanes, shift};
    gpu::Bindings counting, scanning;
    for (const gpu::Binding& b : bindings)
        if (b.name == "keys" || b.name == "keys_storage") counting.push_back(b);
    counting.emplace_back("Counts", counts_);
    recorder.compute("sort-count", pipeline(Kind::count, digits), counting, push, {cut.lanes / 64});
    offer_table(scanning, "counts", counts_);
    scanning.emplace_back("Offsets", offsets_);
    recorder.compute("sort-scan", pipeline(Kind::scan, digits), scanning, push, {});
    offer_table(bindings, "offsets", offsets_);
    recorder.compute("sort-move", pipeline(Kind::move, digits, moves), bindings, push, {cut.lanes / 64});
    lanes_ = cut.lanes;
}

void DeviceSort::sort(gpu::Recorder& recorder, gpu::Buffer& keys, gpu::Buffer& order, std::uint32_t count) {
    gpu::Buffer* const both_keys[] = {&keys, &keys_};
    gpu::Buffer* const both_orders[] = {&order, &order_};
    for (std::uint32_t i = 0; i < 4; ++i) {
        gpu::Bindings bindings;
        offer_table(bindings, "keys", *both_keys[i % 2]);
        if (i > 0) offer_table(bindings, "values", *both_orders[i % 2]);
        bindings.emplace_back("MovedKeys", *both_keys[1 - i % 2]);
        bindings.emplace_back("MovedValues", *both_orders[1 - i % 2]);
        pass(recorder, cut(count), 8 * i, kSortDigits, MOVE_KEYS | (i > 0 ? MOVE_VALUES : 0), std::move(bindings));
    }
}

void DeviceSort::part(gpu::Recorder& recorder, gpu::Buffer& keys, gpu::Buffer* values, gpu::Buffer& order, gpu::Buffer& ranks,
                      std::uint32_t count) {
    gpu::Bindings bindings;
    offer_table(bindings, "keys", keys);
    if (values) offer_table(bindings, "values", *values);
    bindings.emplace_back("MovedValues", order);
    bindings.emplace_back("Ranks", ranks);
    pass(recorder, cut(count), 0, kFewDigits, MOVE_RANKS | (values ? MOVE_VALUES : 0), std::move(bindings));
}

std::uint32_t DeviceSort::zeros(gpu::Device& device) {
    std::uint32_t first_of_ones = 0; // where the first element of digit 1 goes
    gpu::download(device, offsets_, std::as_writable_bytes(std::span(&first_of_ones, 1)), sizeof(std::uint32_t) * lanes_);
    return first_of_ones;
}

} // namespace lightbench
