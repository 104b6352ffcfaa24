// The frame of pairs: one formula in a loop, chosen by a constant, over arguments that change a little with every turn. One turn: its result.
// In: PAIR_ARGUMENTS (floats an invocation) defined, and a function call() below the include.

layout(constant_id = 0) const uint kForm = 0; // 0: nothing but the arguments, 1: stable, 2: naive
layout(local_size_x = 64) in;
layout(push_constant) uniform Push {
    uint count; // invocations
    uint calls; // an invocation: bounded, drivers may end loops silently
};
layout(set = 0, binding = 0) readonly buffer Arguments { float argument_values[]; };
layout(set = 0, binding = 1) writeonly buffer Results { float result_values[]; }; // sum of the results, turns made

float nudge = 1.0; // exactly 1 in the first turn

float argument(uint i) { return argument_values[gl_GlobalInvocationID.x * PAIR_ARGUMENTS + i] * nudge; }
vec3 argument3(uint i) { return vec3(argument(i), argument(i + 1), argument(i + 2)); }

float call();

float all_arguments() {
    float sum = 0.0;
    for (uint i = 0; i < PAIR_ARGUMENTS; ++i) sum += argument(i);
    return sum;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= count) return;
    float total = 0.0;
    uint done = 0;
    for (; done < calls; ++done) {
        nudge = 1.0 + float(done) * 1.1920929e-07;
        total += kForm == 0 ? all_arguments() : call();
    }
    result_values[index * 2] = total;
    result_values[index * 2 + 1] = float(done);
}
