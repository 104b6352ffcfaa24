// Directions to places in pictures of the surroundings. World axes, y up. Directions in, texture coordinates out; u = 2^-24.
// All pictures are as an eye in the middle sees them.
#ifndef LIGHTBENCH_LIB_ENVIRONMENT
#define LIGHTBENCH_LIB_ENVIRONMENT
#include "lib/mapping.glsl"
#include "lib/vector.glsl"

// Equirectangular picture: its middle is -z, its right half the side of +x, its upper edge +y. Blinn, Newell 1976, "Texture and reflection in
// computer generated images". Polar angles come from both legs, so no direction is 0/0, as it is in sphere maps (EN-1).
//   d        |d| in [1e-37, 1e38], not only unit: scaling by a power of two changes no bit; straight up and down u is 0
// Error: absolute 1.5 u in u, 4 u in v (kernel test EquirectUv).
vec2 equirect_uv(vec3 d) {
    vec3 e = d * scale_to_one(largest_magnitude(d));
    return vec2(turns(-e.x, e.z), polar_height(sqrt(e.x * e.x + e.z * e.z), e.y));
}

// The picture of six that a direction meets, in the order +X -X +Y -Y +Z -Z, and where: each upright (v along +y), u to the right as seen from
// within; +Y and -Y continue -Z upwards and downwards. At ties x goes before y before z (EN-2).
//   d        as for equirect_uv; 0 and what is not finite give a face and (1/2, 1/2) or its edge
// Error: absolute 2 u (kernel test CubeFace).
uint cube_face(vec3 d, out vec2 uv) {
    vec3 e = d * scale_to_one(largest_magnitude(d)), a = abs(e);
    bool x = a.x >= a.y && a.x >= a.z, y = !x && a.y >= a.z;
    bool negative = x ? e.x < 0.0 : (y ? e.y < 0.0 : e.z < 0.0);
    float s = negative ? -1.0 : 1.0;
    vec2 side = x ? vec2(s * e.z, e.y) : (y ? vec2(e.x, s * e.z) : vec2(-s * e.x, e.y));
    float major = max(x ? a.x : (y ? a.y : a.z), 1e-37);
    uv = clamp(0.5 * (side / major) + 0.5, 0.0, 1.0);
    return (x ? 0u : (y ? 2u : 4u)) + (negative ? 1u : 0u);
}

// Mirror direction of the direction v to the viewer, R = 2 (N.V) N - V. n of any length in [1e-15, 1e18]: the usual formula would be off by
// 2 |n|^2 - 2 (EN-3).
// Five roundings of the factor enter twice where V is along N; one Newton step on |R|^2 = |V|^2, taken as (V - R).(V + R) so that nothing
// large cancels, takes them out of the length.
//   v        |v| in [1e-15, 1e18]
// Error: | |R| - |V| | <= 4 u |V|, and 10 u |V| from the mirror direction (kernel test Reflected).
vec3 reflected(vec3 n, vec3 v) {
    vec3 r = n * (2.0 * dot(n, v) / dot(n, n)) - v;
    return r + r * (0.5 * dot(v - r, v + r) / dot(v, v));
}

#endif
