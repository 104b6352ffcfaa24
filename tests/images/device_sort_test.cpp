// What building on the device begins with: places along the curve, and words put in order.
#include "images/gpu_fixture.h"

#include "gpu/buffer.h"
#include "render/device_sort.h"
#include "render/shaders.h"
#include "shared/build.h"
#include "shared/effects.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <random>

namespace lightbench {
namespace {

using namespace gpu_layout;

class DeviceSorting : public gpu::GpuTest {};

std::vector<std::uint32_t> random_words(std::size_t count, std::uint32_t below, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> words(count);
    for (std::uint32_t& word : words) word = below == 0 ? random() : random() % below;
    return words;
}

// What each place of the sorted order held before.
std::vector<std::uint32_t> stable_order(const std::vector<std::uint32_t>& keys) {
    std::vector<std::uint32_t> order(keys.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return keys[i]; });
    return order;
}

std::vector<std::uint32_t> words_of(gpu::Device& device, gpu::Buffer& buffer, std::size_t count) {
    auto words = gpu::download_all<std::uint32_t>(device, buffer);
    words.resize(count);
    return words;
}

void expect_sorted(gpu::Device& device, DeviceSort& sort, const std::vector<std::uint32_t>& keys) {
    const auto count = static_cast<std::uint32_t>(keys.size());
    gpu::Buffer key_buffer = make_words(device, "keys", count), order = make_words(device, "order", count);
    gpu::upload(device, key_buffer, std::as_bytes(std::span(keys)));
    gpu::Recorder recorder(device);
    sort.sort(recorder, key_buffer, order, count);
    recorder.submit_and_wait();
    const auto expected = stable_order(keys);
    std::vector<std::uint32_t> sorted;
    for (const std::uint32_t i : expected) sorted.push_back(keys[i]);
    EXPECT_EQ(words_of(device, order, count), expected) << count;
    EXPECT_EQ(words_of(device, key_buffer, count), sorted) << count;
}

TEST_F(DeviceSorting, SortsAsTheStandardLibraryDoes) {
    for (const bool storage : {!device().fits_texel_buffer(4 * 1'000'004), true}) {
        DeviceSort sort(device());
        sort.fit(1'000'003, storage);
        for (const std::size_t count : {1u, 2u, 3u, 4u, 255u, 256u, 257u, 16384u, 65537u, 262145u, 1'000'003u})
            expect_sorted(device(), sort, random_words(count, 0, 5));
        expect_sorted(device(), sort, random_words(100'000, 3, 6));
        expect_sorted(device(), sort, std::vector<std::uint32_t>(70'000, 0xffffffffu));
    }
}

TEST_F(DeviceSorting, PartsByTheLowestBits) {
    DeviceSort sort(device());
    sort.fit(50'000, !device().fits_texel_buffer(4 * 50'000));
    const auto keys = random_words(50'000, 3, 8), values = random_words(50'000, 0, 9);
    gpu::Buffer buffers[4];
    for (gpu::Buffer& buffer : buffers) buffer = make_words(device(), "words", keys.size());
    gpu::upload(device(), buffers[0], std::as_bytes(std::span(keys)));
    gpu::upload(device(), buffers[1], std::as_bytes(std::span(values)));
    gpu::Recorder recorder(device());
    sort.part(recorder, buffers[0], &buffers[1], buffers[2], buffers[3], 50'000);
    recorder.submit_and_wait();
    const auto expected = stable_order(keys), ordered = words_of(device(), buffers[2], keys.size()),
               ranks = words_of(device(), buffers[3], keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        ASSERT_EQ(ordered[i], values[expected[i]]);
        ASSERT_EQ(ranks[expected[i]], i);
    }
    EXPECT_EQ(sort.zeros(device()), std::ranges::count(keys, 0u));
}

std::uint32_t ordered_word(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return bits >> 31 ? ~bits : bits | 0x80000000u;
}

// Twice the centre; the box is that point alone.
std::vector<std::uint32_t> codes_of(gpu::Device& device, const std::vector<glm::vec3>& points) {
    std::vector<uvec4> boxes;
    glm::vec3 low(3.4e38f), high(-3.4e38f);
    for (const glm::vec3& p : points) {
        boxes.insert(boxes.end(), 2, uvec4(glm::floatBitsToUint(p), 0));
        low = glm::min(low, p + p), high = glm::max(high, p + p);
    }
    BuildBounds bounds{};
    for (int i = 0; i < 3; ++i) bounds.low[i] = ordered_word(low[i]), bounds.high[i] = ordered_word(-high[i]);
    gpu::Buffer box_buffer = gpu::make_texel_buffer(device, "boxes", boxes.size() * 16);
    gpu::upload(device, box_buffer, std::as_bytes(std::span(boxes)));
    gpu::Buffer bound_buffer =
        gpu::make_filled_buffer(device, "bounds", std::span<const BuildBounds>(&bounds, 1), vk::BufferUsageFlagBits::eStorageBuffer);
    gpu::Buffer keys = make_words(device, "keys", points.size());
    BuildPush push{};
    push.count = static_cast<std::uint32_t>(points.size());
    const gpu::ComputePipeline pipeline = gpu::make_compute(
        device, find_shader("accel/codes.comp"), {{CONSTANT_FETCH_STORAGE, box_buffer.as_texel() ? 0 : FETCH_BUILD}}, sizeof push);
    gpu::Recorder recorder(device);
    recorder.compute("codes", pipeline, {{"boxes", box_buffer}, {"boxes_storage", box_buffer}, {"Bounds", bound_buffer}, {"Keys", keys}},
                     push, {(push.count + 63) / 64});
    recorder.submit_and_wait();
    return words_of(device, keys, points.size());
}

std::int64_t cell(float x, int k) {
    return static_cast<std::int64_t>(std::floor(std::ldexp(double{x}, k)));
}

// By trying every scale, in whole numbers.
std::vector<std::uint32_t> expected_codes(const std::vector<glm::vec3>& points) {
    glm::vec3 low(3.4e38f), high(-3.4e38f);
    for (const glm::vec3& p : points) low = glm::min(low, p + p), high = glm::max(high, p + p);
    int k = kMortonFinest;
    const auto fits = [&](int axis) { return cell(high[axis], k) - cell(low[axis], k) < (1 << kMortonBits); };
    while (!(fits(0) && fits(1) && fits(2))) --k;
    std::vector<std::uint32_t> codes;
    for (const glm::vec3& p : points) {
        std::uint32_t code = 0;
        for (int bit = kMortonBits - 1; bit >= 0; --bit)
            for (int axis = 0; axis < 3; ++axis)
                code = 2 * code + static_cast<std::uint32_t>((cell(p[axis] + p[axis], k) - cell(low[axis], k)) >> bit & 1);
        codes.push_back(code);
    }
    return codes;
}

TEST_F(DeviceSorting, CodesAreCellsOfTheFinestGridThatFits) {
    std::mt19937 random(3);
    const auto unit = [&] { return static_cast<float>(random()) * 0x1p-32f; };
    for (const float size : {1.9f, 1.0f, 0.9999999f, 0.37f, 1e-3f, 1e-6f, 0.0f})
        for (const glm::vec3& middle : {glm::vec3(0), glm::vec3(1, -0.7f, 0.3f), glm::vec3(-1, 0, 1e-5f)})
            for (const glm::vec3& shape : {glm::vec3(1), glm::vec3(1, 0, 0.001f)}) {
                std::vector<glm::vec3> points{middle, middle - 0.5f * size * shape, middle + 0.5f * size * shape};
                for (int i = 0; i < 500; ++i) points.push_back(middle + size * shape * (glm::vec3(unit(), unit(), unit()) - 0.5f));
                EXPECT_EQ(codes_of(device(), points), expected_codes(points)) << size << " about " << middle.x;
            }
}

} // namespace
} // namespace lightbench
