// The frame of every kernel test: one invocation, one set of arguments, one set of results, one completion flag.
// In: KERNEL_ARGUMENTS and KERNEL_RESULTS (floats an invocation) defined, and a function kernel() below the include.

layout(local_size_x = 64) in;
layout(push_constant) uniform Push {
    uint count;      // invocations
    uint arguments;  // floats an invocation, as the host believes
    uint results;
};
layout(set = 0, binding = 0) readonly buffer Arguments { float argument_values[]; };
layout(set = 0, binding = 1) writeonly buffer Results { float result_values[]; };
layout(set = 0, binding = 2) writeonly buffer Flags { uint flags[]; };

bool finished = true; // a kernel that loops clears it where the loop fell short: drivers may end loops silently

float argument(uint i) { return argument_values[gl_GlobalInvocationID.x * KERNEL_ARGUMENTS + i]; }
vec3 argument3(uint i) { return vec3(argument(i), argument(i + 1), argument(i + 2)); }
void result(uint i, float value) { result_values[gl_GlobalInvocationID.x * KERNEL_RESULTS + i] = value; }
void result3(uint i, vec3 value) {
    result(i, value.x);
    result(i + 1, value.y);
    result(i + 2, value.z);
}

void kernel();

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= count) return;
    kernel();
    if (finished && arguments == KERNEL_ARGUMENTS && results == KERNEL_RESULTS) flags[index] = index + 1;
}
