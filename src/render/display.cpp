// Display and accumulation passes.
#include "render/display.h"

#include "gpu/check.h"
#include "render/raster.h"
#include "render/shaders.h"
#include "shared/layouts.h"

#include <cmath>

namespace lightbench {
namespace {

// Of display.comp, which takes four pixels each.
std::uint32_t invocations(const Display& d) {
    return (d.crop.size.x * d.crop.size.y + 3) / 4;
}

} // namespace

Display make_display(gpu::Device& device, const Plan& plan) {
    Display d;
    d.size = plan.size, d.crop = plan.crop, d.exposure = plan.exposure;
    if (plan.runs("accumulate"))
        d.accumulate = gpu::make_compute(device, find_shader("display/accumulate.comp"), {}, sizeof(gpu_layout::AccumulatePush));
    if (!plan.runs("display")) return d;
    d.display = gpu::make_compute(device, find_shader("display/display.comp"), {}, sizeof(gpu_layout::DisplayPush));
    const auto storage = vk::BufferUsageFlagBits::eStorageBuffer;
    d.pixels = gpu::make_buffer(device, "pixels", vk::DeviceSize{invocations(d) * 16}, storage, gpu::Memory::readback);
    d.census = gpu::make_buffer(device, "census", sizeof(gpu_layout::Census), storage, gpu::Memory::readback);
    return d;
}

gpu::Image make_sum(gpu::Device& device, glm::uvec2 size) {
    return gpu::make_image(device, "sum", {size.x, size.y}, vk::Format::eR32G32B32A32Sfloat,
                           vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eSampled);
}

void record_display(gpu::Recorder& recorder, Display& d, gpu::Image& radiance) {
    recorder.fill(d.census, 0);
    d.shown = d.crop.size.x * d.crop.size.y;
    const gpu_layout::DisplayPush push{d.crop.offset, d.crop.size, std::exp2(d.exposure), 0, 0, 0};
    recorder.compute("display", d.display, {{"radiance", radiance}, {"Pixels", d.pixels}, {"CensusBlock", d.census}}, push,
                     groups_for(invocations(d)));
}

void clear_pixels(gpu::Recorder& recorder, Display& d) {
    recorder.fill(d.census, 0);
    recorder.fill(d.pixels, 0xff000000u);
    d.shown = 0;
}

void record_accumulate(gpu::Recorder& recorder, Display& d, gpu::Image& frame, gpu::Image& sum, float weight, std::uint32_t mode) {
    const gpu_layout::AccumulatePush push{d.size, weight, mode};
    recorder.compute("accumulate", d.accumulate, {{"frame", frame}, {"sum", sum}}, push, {(d.size.x + 15) / 16, (d.size.y + 3) / 4});
}

Image8 read_pixels(gpu::Device& device, Display& d, const Rect& crop) {
    std::vector<std::uint8_t> rgba = gpu::download_all<std::uint8_t>(device, d.pixels);
    rgba.resize(std::size_t{4} * crop.size.x * crop.size.y); // the last four may be fewer
    return {crop.size.x, crop.size.y, std::move(rgba)};
}

std::uint64_t read_census(gpu::Device& device, Display& d) {
    const auto census = gpu::download_all<gpu_layout::Census>(device, d.census).front();
    CHECK(census.visited == d.shown, "while displaying: the driver left out pixels");
    return census.non_finite;
}

// Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", PCG2D: two well mixed words from a counter and a seed.
glm::dvec2 jitter(std::uint32_t seed, std::uint32_t frame) {
    std::uint32_t x = frame * 1664525u + 1013904223u, y = seed * 1664525u + 1013904223u;
    for (int round = 0; round < 2; ++round) {
        x += y * 1664525u, y += x * 1664525u;
        x ^= x >> 16, y ^= y >> 16;
    }
    return {x * 0x1p-32, y * 0x1p-32};
}

} // namespace lightbench
