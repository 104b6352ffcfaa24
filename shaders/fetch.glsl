// Read-only scene data as tables of uvec4, whatever the device likes to read them from: texel buffers, 14 times faster than storage
// buffers on a CPU driver, or storage buffers where a table has more elements than a texel buffer may have (SwiftShader: 65 536).
// One of the two bindings is dead once CONSTANT_FETCH_STORAGE is frozen, and is stripped.
#ifndef LIGHTBENCH_FETCH_GLSL
#define LIGHTBENCH_FETCH_GLSL

#include "shared/effects.h"

layout(constant_id = CONSTANT_FETCH_STORAGE) const uint kFetchStorage = 0u;

// Declares `uvec4 fetch_NAME(uint i)`; BIT is its FETCH_... bit, BINDING and BINDING + 1 are its binding numbers.
#define FETCH_TABLE(NAME, BIT, BINDING)                                                                   \
    layout(set = 0, binding = BINDING) uniform utextureBuffer NAME;                                       \
    layout(set = 0, binding = BINDING + 1, scalar) readonly buffer NAME##_storage { uvec4 NAME##_words[]; }; \
    uvec4 fetch_##NAME(uint i) {                                                                          \
        if ((kFetchStorage & BIT) != 0u) return NAME##_words[i];                                          \
        return texelFetch(NAME, int(i));                                                                  \
    }

#endif
