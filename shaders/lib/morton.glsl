// Places along a curve that keeps near things near. Pure integers.
#ifndef LIGHTBENCH_LIB_MORTON_GLSL
#define LIGHTBENCH_LIB_MORTON_GLSL

// Two zeros between the lowest ten bits. The masks: Karras 2012, "Thinking Parallel, Part III".
uint spread_by_three(uint x) {
    x = (x | x << 16u) & 0x030000ffu;
    x = (x | x << 8u) & 0x0300f00fu;
    x = (x | x << 4u) & 0x030c30c3u;
    return (x | x << 2u) & 0x09249249u;
}

// Morton 1966, "A computer oriented geodetic data base": bits of x, y, z in turn, those of x the highest.
//   cell  each coordinate in [0, 1023]
//   returns 30 bits
uint morton_code(uvec3 cell) { return spread_by_three(cell.x) << 2u | spread_by_three(cell.y) << 1u | spread_by_three(cell.z); }

// Floats as words of the same order; -0 comes before +0.
uint ordered_word(float x) {
    uint bits = floatBitsToUint(x);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float ordered_float(uint word) { return uintBitsToFloat((word & 0x80000000u) != 0u ? word & 0x7fffffffu : ~word); }

#endif
