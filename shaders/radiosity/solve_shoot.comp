// Shoots a batch (S30): H_i += energy_j F_ji / A_i, dB_i += rho_i times that; what the shooters had is gone, and what they get from each
// other stays with them. In: energies, rows, states. Out: the states after it, in another buffer. An invocation an element.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "fetch.glsl"
#include "lib/sum.glsl"
#include "shared/radiosity.h"
#include "shared/solve.h"

layout(local_size_x = 128) in;
layout(push_constant, scalar) uniform Push { ShootPush push; };
FETCH_TABLE(elements, FETCH_SOLVE_TABLES, 0)
FETCH_TABLE(state, FETCH_SOLVE_TABLES, 2)
FETCH_TABLE(shots, FETCH_SOLVE_TABLES, 4)
FETCH_TABLE(rows, FETCH_SOLVE_ROWS, 6)
layout(set = 0, binding = 8, scalar) writeonly buffer After { SolveState after[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= push.elements) return;
    uint own = fetch_elements(kSolveElementTexels * i + 1u).x;
    bool shoots = false;
    Sum3 arrived = sum_start();
    for (uint k = 0u; k < push.batch; ++k) {
        uvec4 shot = fetch_shots(k);
        uint at = k * push.elements + i;
        sum_add(arrived, uintBitsToFloat(shot.xyz) * float(fetch_rows(at >> 2u)[at & 3u]));
        shoots = shoots || shot.w == own;
    }
    vec4 surface = uintBitsToFloat(fetch_elements(kSolveElementTexels * i)); // rho, area
    vec4 a = uintBitsToFloat(fetch_state(kSolveStateTexels * i)), b = uintBitsToFloat(fetch_state(kSolveStateTexels * i + 1u));
    vec4 c = uintBitsToFloat(fetch_state(kSolveStateTexels * i + 2u));
    Sum3 received = Sum3(a.xyz, b.xyz);
    Sum3 unshot = shoots ? sum_start() : Sum3(vec3(a.w, b.w, c.w), c.xyz);
    vec3 irradiance = sum_result(arrived) / surface.w;
    sum_add(received, irradiance);
    sum_add(unshot, surface.xyz * irradiance);
    after[i] = SolveState(received.total, unshot.total.x, received.carry, unshot.total.y, unshot.carry, unshot.total.z);
}
