// Chooses the patches of largest unshot energy (S30): the channels' sum of area times dB; of equal ones the lowest number first.
// In: tallies. Out: numbers for the hemi-cubes, energies for the shots; kNoElement and 0 where nothing is left. One work group.
// Each lane keeps the best of every 256th patch; only the lane that gave the winner looks again, for its best after that one.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "fetch.glsl"
#include "shared/radiosity.h"
#include "shared/solve.h"

layout(local_size_x = 256) in;
layout(push_constant, scalar) uniform Push { ChoosePush push; };
FETCH_TABLE(tally, FETCH_SOLVE_TABLES, 0)
layout(set = 0, binding = 2, scalar) writeonly buffer Chosen { uint chosen[]; };
layout(set = 0, binding = 3, scalar) writeonly buffer Shots { SolveShot shots[]; };

// (bits of the key, number). Bits of floats that are not negative are ordered as the floats are.
const uvec2 kNobody = uvec2(0u, kNoElement);
shared uvec2 best_of_lane[kChooseLanes];
shared uvec2 best_of_sixteen[kChooseLanes / 16u];
shared uvec2 winner;

bool before(uvec2 a, uvec2 b) { return a.x > b.x || (a.x == b.x && a.y < b.y); }

// The best of the lane's patches among those after `previous`.
uvec2 best_after(uvec2 previous, uint lane) {
    uvec2 best = kNobody;
    for (uint p = lane; p < push.patches; p += kChooseLanes) {
        uvec2 candidate = uvec2(fetch_tally(kSolveTallyTexels * p).w, p);
        if (candidate.x > 0u && before(previous, candidate) && before(candidate, best)) best = candidate;
    }
    return best;
}

void find_winner(uvec2 mine, uint lane) {
    best_of_lane[lane] = mine;
    barrier();
    if (lane < kChooseLanes / 16u) {
        uvec2 best = kNobody;
        for (uint i = 0u; i < 16u; ++i) best = before(best_of_lane[16u * lane + i], best) ? best_of_lane[16u * lane + i] : best;
        best_of_sixteen[lane] = best;
    }
    barrier();
    if (lane == 0u) {
        uvec2 best = kNobody;
        for (uint i = 0u; i < kChooseLanes / 16u; ++i) best = before(best_of_sixteen[i], best) ? best_of_sixteen[i] : best;
        winner = best;
    }
    barrier();
}

void main() {
    uint lane = gl_LocalInvocationID.x;
    uvec2 mine = best_after(uvec2(0xffffffffu, 0u), lane);
    for (uint round = 0u; round < push.batch; ++round) {
        find_winner(mine, lane);
        uvec2 won = round < push.most ? winner : kNobody;
        if (lane == 0u) {
            vec3 energy = won.x > 0u ? uintBitsToFloat(fetch_tally(kSolveTallyTexels * min(won.y, push.patches - 1u)).xyz) : vec3(0.0);
            chosen[round] = won.y;
            shots[round] = SolveShot(energy, won.y);
        }
        if (won.x > 0u && won.y % kChooseLanes == lane) mine = best_after(won, lane);
    }
}
