// Delta form factors of a hemi-cube summed by element: one invocation a row of pixels, one layer of work groups a hemi-cube; runs of one
// element are summed first. In: items, the table of delta form factors. Out: rows. Whole numbers: the order does not matter.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "radiosity/hemicube_view.glsl"
#include "shared/rays.h"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { HemicubePush push; };
FETCH_TABLE(items, FETCH_HEMICUBE_ITEMS, 52)
FETCH_TABLE(deltas, FETCH_HEMICUBE_DELTAS, 54)
layout(set = 0, binding = 36, scalar) buffer Counters { RayCounters counters; };
layout(set = 0, binding = 56, scalar) buffer Rows { uint rows[]; };

uint component(uvec4 four, uint i) { return (i & 2u) == 0u ? ((i & 1u) == 0u ? four.x : four.y) : ((i & 1u) == 0u ? four.z : four.w); }
uint read_item(uint i) { return component(fetch_items(i >> 2u), i); }
uint read_delta(uint i) { return component(fetch_deltas(i >> 2u), i); }

void main() {
    uint row = gl_GlobalInvocationID.x, cube = gl_WorkGroupID.z;
    const uint top = kResolution * kResolution, half_rows = kResolution / 2u;
    if (row >= 3u * kResolution) return;
    HemicubeView v = read_view(cube);
    uint item_at = cube * kItems + row * kResolution;
    uint delta_at = row < kResolution ? row * kResolution : top + (row - kResolution) % half_rows * kResolution;
    uint run = kNoElement, sum = 0u;
    for (uint x = 0u; x < kResolution; ++x) {
        uint item = read_item(item_at + x);
        // A patch does not see itself (HC-10); what is none counts nothing.
        if (item != run && run != kNoElement && run - v.first >= v.count) atomicAdd(rows[cube * push.elements + run], sum);
        sum = (item == run ? sum : 0u) + read_delta(delta_at + x);
        run = item;
    }
    if (run != kNoElement && run - v.first >= v.count) atomicAdd(rows[cube * push.elements + run], sum);
    atomicAdd(counters.done, 1u);
}
