// Reconstruction filter wider than a pixel (S25): adds the samples of one frame to the weighted means of the pixels that they lie near.
// In: a frame, one sample a pixel, with a margin around it. Out: means of linear radiance; their alpha is the sum of the weights.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/effects.h"
#include "shared/rays.h"
#include "lib/filter.glsl"

layout(constant_id = CONSTANT_RAY_EFFECTS) const uint kRayEffects = 0u;
layout(local_size_x = 16, local_size_y = 4) in;
layout(push_constant, scalar) uniform Push { FilterPush push; };
layout(set = 0, binding = 0, rgba32f) readonly uniform image2D frame;
layout(set = 0, binding = 1, rgba32f) uniform image2D sum;

#define wants_ray(effect) ((kRayEffects & (effect)) != 0u)

#include "raytrace/sample.glsl"

void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    if (at.x >= push.size.x || at.y >= push.size.y) return;
    ivec2 pixel = ivec2(push.corner + at);
    vec4 mean = push.first != 0u ? vec4(0.0) : imageLoad(sum, pixel);
    int margin = int(push.margin), side = 2 * margin + 1;
    for (int i = 0; i < side * side; ++i) {
        ivec2 step = ivec2(i % side, i / side) - margin;
        uint key;
        vec2 within = sample_within(uvec2(pixel + step), push.sample_index, push.seed, push.shift, push.cell, key);
        vec4 found = imageLoad(frame, ivec2(at) + margin + step); // alpha 0: not traced
        float weight = found.a * filter_gaussian(vec2(step) + within - 0.5, push.radius, push.sigma);
        if (weight <= 0.0) continue;
        // West 1979, "Updating mean and variance estimates", CACM 22(9): a mean of equal samples stays that sample, to the bit (AA-4).
        float before = mean.a;
        mean.a += weight;
        mean.rgb = before > 0.0 ? mean.rgb + (found.rgb - mean.rgb) * (weight / mean.a) : found.rgb;
    }
    imageStore(sum, pixel, mean);
}
