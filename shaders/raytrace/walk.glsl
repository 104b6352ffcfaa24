// The state of a walk through a structure, which can be put down and taken up again: work per dispatch is bounded, since some drivers end
// long loops without a word (lavapipe: 65 535 rounds for eight invocations).
#ifndef LIGHTBENCH_RAYTRACE_WALK_GLSL
#define LIGHTBENCH_RAYTRACE_WALK_GLSL

#include "raytrace/rays.glsl"

layout(constant_id = CONSTANT_STACK) const uint kStack = 64u;
const uint kStepBudget = 8000u; // rounds of an invocation: eight of them, each waiting for the others, stay below 65 535
const uint kPacketBudget = 40000u; // of a walk that the eight take together

struct Walk {
    uint node; // kNothing: ended
    uint top;  // entries of the stack
    uint a, b; // what else a structure has to remember
};
uint stack[kStack];

FETCH_TABLE(nodes, FETCH_NODES, 4)

#endif
