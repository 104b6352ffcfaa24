// Before a batch is shot: sums each row of form factors, brings those above 1 down to 1 (RS-1), and books what leaves the scene.
// In: rows, energies. Out: energies in units of a row's entries. A work group a row.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "fetch.glsl"
#include "lib/sum.glsl"
#include "shared/solve.h"

layout(local_size_x = 128) in;
layout(push_constant, scalar) uniform Push { ShootPush push; };
FETCH_TABLE(rows, FETCH_SOLVE_ROWS, 0)
layout(set = 0, binding = 2, scalar) buffer Shots { SolveShot shots[]; };
layout(set = 0, binding = 3, scalar) buffer Slots { SolveSlot slots[]; };
#include "radiosity/solve_row_sum.glsl"

const float kEntry = 1.0 / float(kHemicubeOne);

void main() {
    uint k = gl_WorkGroupID.x, lane = gl_LocalInvocationID.x;
    SolveRowSum sum = sum_row(k * push.elements, push.elements, lane);
    if (lane != 0u) return;
    SolveShot shot = shots[k];
    SolveSlot slot = slots[k];
    Sum3 escaped = Sum3(slot.escaped, slot.escaped_carry);
    if (sum.high < (kHemicubeOne >> 16u))
        sum_add(escaped, shot.energy * (float(kHemicubeOne - (sum.high << 16u) - sum.low) * kEntry));
    slots[k] = SolveSlot(escaped.total, slot.shots + (shot.patch_number != kNoElement ? 1u : 0u), escaped.carry, 0u);
    shots[k].energy = shot.energy * (sum.scale * kEntry);
}
