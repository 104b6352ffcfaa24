// Rays as texels to be stored.
#ifndef LIGHTBENCH_RAYTRACE_PACK_GLSL
#define LIGHTBENCH_RAYTRACE_PACK_GLSL

#include "shared/rays.h"

// Stored by whole texels: a CPU driver stores each member of a struct apart, at the price of a texel each.
void pack_ray(Ray r, out uvec4 a, out uvec4 b, out uvec4 c) {
    a = uvec4(floatBitsToUint(r.origin), floatBitsToUint(r.after));
    b = uvec4(floatBitsToUint(r.direction), r.after_number);
    c = uvec4(floatBitsToUint(r.width), r.level, floatBitsToUint(r.weight), r.key);
}

#endif
