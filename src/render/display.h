// From linear radiance to pixels on the device, and the running sum of frames. In: radiance. Out: 8-bit sRGB, and a census of it.
#pragma once

#include "gpu/recorder.h"
#include "image/image.h"
#include "plan/plan.h"

namespace lightbench {

struct Display {
    gpu::ComputePipeline display, accumulate; // none if the plan has no such pass
    gpu::Buffer pixels, census;
    glm::uvec2 size{0};
    Rect crop{};
    float exposure = 0;
    std::uint32_t shown = 0; // pixels that must have been visited
};

Display make_display(gpu::Device& device, const Plan& plan);
gpu::Image make_sum(gpu::Device& device, glm::uvec2 size);

void record_display(gpu::Recorder& recorder, Display& display, gpu::Image& radiance);
// Black pixels, for passes that write some of them.
void clear_pixels(gpu::Recorder& recorder, Display& display);
void record_accumulate(gpu::Recorder& recorder, Display& display, gpu::Image& frame, gpu::Image& sum, float weight,
                       std::uint32_t mode); // ACCUMULATE_...

Image8 read_pixels(gpu::Device& device, Display& display, const Rect& crop);
std::uint64_t read_census(gpu::Device& device, Display& display); // CHECKs that no pixel was missed

// Counter-based jitter within a cell, [0, 1)^2: the same for a seed and a frame whatever else is drawn.
glm::dvec2 jitter(std::uint32_t seed, std::uint32_t frame);

} // namespace lightbench
