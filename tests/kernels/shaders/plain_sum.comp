// compensated_sum.comp without the compensation: what the bound must catch.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/sum.glsl"

layout(local_size_x = 8) in;
layout(push_constant) uniform Push {
    uint first;
    uint length; // bounded: drivers may end loops silently
    uint terms;  // in the ring
    uint shift;  // between the starts of two invocations
};
layout(set = 0, binding = 0) readonly buffer Terms { float term[]; };
layout(set = 0, binding = 1) buffer State { float state[]; };  // total and carry, 6 floats an invocation
layout(set = 0, binding = 2) buffer Counts { uint counts[]; }; // terms added so far
layout(set = 0, binding = 3) writeonly buffer Results { float results[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    uint at = index * 6;
    Sum3 sum = Sum3(vec3(state[at], state[at + 1], state[at + 2]), vec3(state[at + 3], state[at + 4], state[at + 5]));
    uint place = (index * shift + first) % terms;
    uint steps = 0;
    for (uint i = 0; i < length; ++i, ++steps) {
        float x = term[place];
        sum.total += vec3(x, 3.0 * x, -x);
        place = place + 1 == terms ? 0 : place + 1;
    }
    for (uint i = 0; i < 3; ++i) state[at + i] = sum.total[i];
    for (uint i = 0; i < 3; ++i) state[at + 3 + i] = sum.carry[i];
    vec3 total = sum_result(sum);
    for (uint i = 0; i < 3; ++i) results[index * 3 + i] = total[i];
    counts[index] += steps;
}
