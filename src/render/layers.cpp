// Counting, listing, sorting and blending of layers.
#include "render/layers.h"

#include "gpu/check.h"
#include "gpu/errors.h"
#include "gpu/memory_budget.h"
#include "render/shaders.h"
#include "shared/effects.h"
#include "shared/layouts.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr std::uint64_t kRecordBytes = 16, kKeyBytes = 16;
constexpr std::uint32_t kMostInRegisters = 16; // layers that blend_layers.comp can sort
// The last level of the sort loops once a layer and once more at a tie; lavapipe ends loops after 65 535 iterations of a SIMD group.
constexpr std::uint32_t kMostLayers = 30000;
constexpr auto kStorage = vk::BufferUsageFlagBits::eStorageBuffer;

// Buffers for tables are made anew when they are too small; half as large again, so that a moving view does not do so every frame.
void grow(gpu::Device& device, gpu::Buffer& buffer, const char* name, std::uint64_t bytes, std::uint64_t largest) {
    if (buffer && buffer.size() >= bytes) return;
    buffer = {};
    buffer =
        gpu::make_texel_buffer(device, name, std::min(std::max<std::uint64_t>(bytes + bytes / 2, 16) / 16 * 16, std::max(largest, bytes)));
}

// Where the opacity of a record is found depends on these.
std::uint32_t effects_of(const LayerWork& w) {
    return w.variant.effects & (EFFECT_TEXTURE_ALPHA | EFFECT_MANY_MATERIALS);
}

// `number`: see the shader.
const gpu::ComputePipeline& pipeline_of(Layers& layers, const LayerWork& w, const char* shader, std::uint32_t number) {
    gpu::ComputePipeline& pipeline = layers.pipelines[{shader, effects_of(w), number}];
    const gpu::Constants constants{
        {CONSTANT_EFFECTS, effects_of(w)}, {CONSTANT_FETCH_STORAGE, w.scene.fetch_storage}, {CONSTANT_LAYERS, number}};
    if (!pipeline) pipeline = gpu::make_compute(w.device, find_shader(shader), constants, sizeof(gpu_layout::LayersPush));
    return pipeline;
}

void submit(const LayerWork& w) {
    const auto times = w.recorder.submit_and_wait();
    w.times.insert(w.times.end(), times.begin(), times.end());
}

vk::Rect2D rect_of(const Rect& crop, const LayerTile& tile) {
    return {{static_cast<std::int32_t>(crop.offset.x + tile.x), static_cast<std::int32_t>(crop.offset.y + tile.y)},
            {tile.width, tile.height}};
}

std::vector<std::uint32_t> count_layers(Layers& layers, const LayerWork& w) {
    const Rect& crop = w.plan.crop;
    const std::uint64_t bytes = std::uint64_t{crop.size.x} * crop.size.y * 4;
    if (!layers.counts) {
        layers.counts = gpu::make_texel_buffer(w.device, "layer-counts", (bytes + 15) / 16 * 16);
        layers.cursors = gpu::make_buffer(w.device, "layer-cursors", bytes, kStorage);
    }
    w.recorder.fill(layers.counts, 0);
    RasterVariant places = w.variant;
    places.output = OUTPUT_DEPTH;
    const LayerTile whole{0, 0, crop.size.x, crop.size.y};
    record_translucent(w.recorder, w.plan, w.scene, w.geometry, places, w.targets, w.draw,
                       {"count-layers", w.pipelines.count, rect_of(crop, whole), {{"Counts", layers.counts}}, crop.offset, crop.size.x});
    submit(w);
    std::vector<std::uint32_t> counts = gpu::download_all<std::uint32_t>(w.device, layers.counts);
    counts.resize(std::size_t{crop.size.x} * crop.size.y); // without what fills the last texel
    return counts;
}

// Pixels whose numbers of layers agree to a factor of 2: `deep` from first to first + count, none with more than `most`.
struct DeepBin {
    std::uint32_t first = 0, count = 0, most = 0;
};

// Where the records of each block begin, and the most layers of its pixels; the pixels with more layers than registers hold.
struct TileLists {
    std::vector<glm::uvec4> blocks;
    std::vector<std::uint32_t> deep;
    std::vector<DeepBin> bins;
};

// A level of the sort gives every pixel of a bin as many invocations as its deepest needs.
void add_deep_pixels(TileLists& lists, const LayerTile& tile, std::span<const std::uint32_t> counts, std::uint32_t width) {
    std::map<int, std::vector<std::uint32_t>> pixels; // by the power of two of their layers
    std::map<int, std::uint32_t> most;
    for (std::uint32_t y = 0; y < tile.height; ++y)
        for (std::uint32_t x = 0; x < tile.width; ++x) {
            const std::uint32_t n = counts[std::size_t{tile.y + y} * width + tile.x + x];
            if (n <= kMostInRegisters) continue;
            const int power = std::bit_width(n);
            pixels[power].push_back(y * tile.width + x);
            most[power] = std::max(most[power], n);
        }
    for (const auto& [power, numbers] : pixels) {
        lists.bins.push_back({static_cast<std::uint32_t>(lists.deep.size()), static_cast<std::uint32_t>(numbers.size()), most[power]});
        lists.deep.insert(lists.deep.end(), numbers.begin(), numbers.end());
    }
}

TileLists lists_of(const LayerTile& tile, std::span<const std::uint32_t> counts, std::uint32_t width) {
    TileLists lists;
    add_deep_pixels(lists, tile, counts, width);
    std::uint32_t records = 0;
    for (std::uint32_t y = 0; y < tile.height; y += kBlock)
        for (std::uint32_t x = 0; x < tile.width; x += kBlock) {
            const std::uint32_t most = most_in_block(counts, width, tile.x + x, tile.y + y, tile.x + tile.width, tile.y + tile.height);
            lists.blocks.emplace_back(records, most, pixels_of_block(tile), 0);
            records += most * pixels_of_block(tile);
        }
    CHECK(records == tile.records);
    return lists;
}

void upload_lists(Layers& layers, const LayerWork& w, const LayerTile& tile, TileLists& lists, std::uint64_t largest) {
    grow(w.device, layers.blocks, "layer-blocks", lists.blocks.size() * sizeof(glm::uvec4), largest);
    gpu::upload(w.device, layers.blocks, std::as_bytes(std::span(lists.blocks)));
    grow(w.device, layers.records, "layers", tile.records * kRecordBytes, largest);
    if (effects_of(w) & EFFECT_TEXTURE_ALPHA)
        grow(w.device, layers.opacities, "layer-opacities", tile.records * kRecordBytes, largest);
    else if (effects_of(w) & EFFECT_MANY_MATERIALS)
        grow(w.device, layers.surfaces, "layer-surfaces", (tile.records * 4 + 15) / 16 * 16, largest);
    if (lists.deep.empty()) return;
    lists.deep.resize((lists.deep.size() + 3) / 4 * 4, lists.deep.front());
    grow(w.device, layers.deep_pixels, "deep-pixels", lists.deep.size() * 4, largest);
    gpu::upload(w.device, layers.deep_pixels, std::as_bytes(std::span(lists.deep)));
    for (gpu::Buffer& keys : layers.keys) grow(w.device, keys, "layer-keys", tile.records * kKeyBytes, largest);
}

gpu::Bindings bindings_of(Layers& layers, const LayerWork& w) {
    gpu::Bindings bindings{{"radiance", w.targets.resolved}, {"Cursors", layers.cursors}};
    offer_table(bindings, "counts", layers.counts);
    offer_table(bindings, "blocks", layers.blocks);
    offer_table(bindings, "layers", layers.records);
    offer_table(bindings, "layer_surfaces", layers.surfaces);
    offer_table(bindings, "layer_opacities", layers.opacities);
    offer_table(bindings, "materials", w.scene.materials);
    return bindings;
}

void blend_few(Layers& layers, const LayerWork& w, const LayerTile& tile, const gpu_layout::LayersPush& push) {
    const std::uint32_t most = std::clamp(std::bit_ceil(tile.most), 2u, kMostInRegisters);
    w.recorder.compute("blend-layers", pipeline_of(layers, w, "raster/blend_layers.comp", most), bindings_of(layers, w), push,
                       groups_for(tile.width * tile.height));
}

// A merge sort, one dispatch a level: the work of an invocation is bounded by the run that it writes.
void blend_many(Layers& layers, const LayerWork& w, const DeepBin& bin, gpu_layout::LayersPush push) {
    gpu::Bindings bindings = bindings_of(layers, w);
    offer_table(bindings, "deep_pixels", layers.deep_pixels);
    push.first_deep = bin.first, push.deep_count = bin.count;
    unsigned from = 1;
    for (push.run = 1; push.run < bin.most; push.run *= 2) {
        gpu::Bindings level = bindings;
        offer_table(level, "keys_in", layers.keys[from]);
        level.emplace_back("KeysOut", layers.keys[1 - from]);
        push.pairs = (bin.most + 2 * push.run - 1) / (2 * push.run);
        const auto& pipeline = pipeline_of(layers, w, "raster/merge_layers.comp", push.run == 1 ? 1 : 0);
        w.recorder.compute("sort-layers", pipeline, level, push, groups_for(push.pairs * push.deep_count));
        from = 1 - from;
    }
    offer_table(bindings, "keys_in", layers.keys[from]);
    w.recorder.compute("blend-layers", pipeline_of(layers, w, "raster/blend_deep_layers.comp", 0), bindings, push,
                       groups_for(push.deep_count));
}

std::size_t record_tile(Layers& layers, const LayerWork& w, const LayerTile& tile, std::span<const std::uint32_t> counts,
                        std::uint64_t largest) {
    TileLists lists = lists_of(tile, counts, w.plan.crop.size.x);
    submit(w); // what reads the buffers that are filled now
    upload_lists(layers, w, tile, lists, largest);
    w.recorder.fill(layers.cursors, 0);
    const glm::uvec2 origin = w.plan.crop.offset + glm::uvec2(tile.x, tile.y);
    TranslucentDraw draw{
        "list-layers", w.pipelines.list, rect_of(w.plan.crop, tile), {{"Cursors", layers.cursors}, {"Layers", layers.records}},
        origin,        tile.width};
    if (layers.surfaces) draw.bindings.emplace_back("Surfaces", layers.surfaces);
    if (layers.opacities) draw.bindings.emplace_back("Opacities", layers.opacities);
    offer_table(draw.bindings, "blocks", layers.blocks);
    const std::size_t triangles = record_translucent(w.recorder, w.plan, w.scene, w.geometry, w.variant, w.targets, w.draw, draw);
    const gpu_layout::LayersPush push{origin, {tile.width, tile.height}, w.plan.crop.offset, w.plan.crop.size.x, 0, 0, 0, 0, 0};
    blend_few(layers, w, tile, push);
    for (const DeepBin& bin : lists.bins) blend_many(layers, w, bin, push);
    return triangles;
}

// Bytes that a list may have: one binding of a storage buffer, and a quarter of the memory that is allowed (keys twice beside it).
std::uint64_t largest_list(const Layers& layers, const LayerWork& w) {
    const gpu::DeviceInfo& info = w.device.info();
    const std::uint64_t most = std::min(info.max_storage_range, gpu::memory_budget(info.heap_bytes, info.is_cpu) / 4);
    return layers.largest ? std::min(layers.largest, most) : most;
}

} // namespace

std::size_t record_layers(Layers& layers, const LayerWork& w) {
    const std::vector<std::uint32_t> counts = count_layers(layers, w);
    const std::uint64_t largest = largest_list(layers, w);
    const auto tiles = cut_into_tiles(counts, w.plan.crop.size.x, largest / kRecordBytes);
    std::size_t triangles = 0;
    for (const LayerTile& tile : tiles) {
        if (tile.records * kRecordBytes > largest)
            throw gpu::EnvironmentError(fmt::format("a pixel has {} translucent layers, and {} hold {}", tile.most,
                                                    gpu::show_bytes(largest), largest / kRecordBytes));
        if (tile.most > kMostLayers)
            throw gpu::EnvironmentError(fmt::format("a pixel has {} translucent layers; at most {} can be sorted", tile.most, kMostLayers));
        triangles += record_tile(layers, w, tile, counts, largest);
    }
    return triangles;
}

} // namespace lightbench
