// Where on the curve the primitives lie. In: boxes by number, bounds. Out: codes by number.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/build.glsl"
#include "lib/morton.glsl"

FETCH_BOXES(boxes, 0)
layout(set = 0, binding = 2, scalar) readonly buffer Bounds { BuildBounds bounds; };
layout(set = 0, binding = 3, scalar) writeonly buffer Keys { uint keys[]; };

vec3 cells(vec3 x, int k) { return floor(x * uintBitsToFloat(uint(k + 127) << 23u)); }

bool fits(vec3 low, vec3 high, int k) { return all(lessThan(cells(high, k) - cells(low, k), vec3(1 << kMortonBits))); }

// See kMortonBits. A width in [2^(e-1), 2^e) has 2^9 to 2^10 + 1 cells of side 2^(e - 10); rounding may have made e too large by one.
int finest(vec3 low, vec3 high) {
    precise vec3 width = high - low;
    int exponent = int(floatBitsToUint(max(width.x, max(width.y, width.z))) >> 23u) - 126;
    int k = clamp(int(kMortonBits) + 1 - exponent, -100, kMortonFinest);
    if (!fits(low, high, k)) --k;
    return fits(low, high, k) ? k : k - 1;
}

void main() {
    uint i = invocation();
    if (i >= push.count) return;
    vec3 low = vec3(ordered_float(bounds.low[0]), ordered_float(bounds.low[1]), ordered_float(bounds.low[2]));
    vec3 high = -vec3(ordered_float(bounds.high[0]), ordered_float(bounds.high[1]), ordered_float(bounds.high[2]));
    int k = finest(low, high);
    Box box = boxes_box(i);
    precise vec3 center = box.low + box.high;
    ivec3 cell = ivec3(cells(center, k)) - ivec3(cells(low, k));
    keys[i] = morton_code(uvec3(clamp(cell, ivec3(0), ivec3((1 << kMortonBits) - 1))));
}
