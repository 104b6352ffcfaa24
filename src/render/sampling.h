// How the samples of the ray tracer become pixels, where that is more than one each: a filter wider than a pixel (S25), adaptive
// supersampling (S26). In: a tracer, a frame's view and light. Out: linear radiance of the plan's crop. A crop gets the bits of the whole.
#pragma once

#include "render/raytrace.h"

namespace lightbench {

// One frame with a margin, so that pixels at the border see the samples beside the crop, and beside the picture, as all others do.
struct WideFilter {
    gpu::ComputePipeline pipeline;
    gpu::Image frame;
    std::uint32_t margin = 0; // pixels
};

WideFilter make_wide_filter(gpu::Device& device, const Plan& plan);

// Adds the samples of `frame` (its area and origin are set here) to the means in `sum`. False: stopped early.
bool trace_filtered(RayTracer& tracer, const RayWork& work, RayFrame frame, WideFilter& filter, gpu::Image& sum);

// Points 2^-max_level pixels apart over as many rows of pixels as there is room for; bands share the row of points between them.
struct Lattice {
    gpu::ComputePipeline split, list, pixels;
    gpu::Buffer radiance, states, points, listed; // of a band; the points to trace, their number
    gpu::Buffer row_radiance, row_states;         // the last row of the band before
    std::uint32_t width = 0, rows = 0;            // pixels of a band at most
    std::uint32_t levels = 0;
};

constexpr std::uint64_t kLatticePoints = 1u << 21; // 36 bytes each

// `room`: points of a band. A row of pixels that has more is cut into strips, which trace the points between them twice.
Lattice make_lattice(gpu::Device& device, const Plan& plan, RayTracer& tracer, std::uint64_t room = kLatticePoints);

// Writes the plan's crop of `image`. False: stopped early; the bands that were not reached are not written.
bool trace_adaptive(RayTracer& tracer, const RayWork& work, RayFrame frame, Lattice& lattice, gpu::Image& image);

} // namespace lightbench
