// Normals tilted by surface gradients. Vectors in and out; u = 2^-24.
// Mikkelsen 2020, "Surface gradient-based bump mapping framework", JCGT 9(3): a bump, whatever it comes from, is a vector in the tangent
// plane; bumps add up, and the normal is n - gradient. Blinn 1978, "Simulation of wrinkled surfaces", is the same for parametric surfaces.
#ifndef LIGHTBENCH_LIB_BUMP
#define LIGHTBENCH_LIB_BUMP
#include "lib/vector.glsl"

// The normal of the surface that was raised by a height with this gradient.
// Mikkelsen 2010, "Bump mapping unparametrized surfaces on the GPU", eq. 4.
//   n                 unit to 6 u
//   surface_gradient  of the height, length over length; its part along n is taken off; below 1e15
//   returns a unit vector; a NaN goes through
// Error: absolute 8 u, 6 u in its length, plus what the part along n adds: u |part| (kernel test PerturbNormal).
vec3 perturb_normal(vec3 n, vec3 surface_gradient) {
    vec3 tangential = surface_gradient - n * dot(n, surface_gradient);
    return fast_normalize(n - tangential);
}

// The shading normal where it faces the viewer; elsewhere the nearest direction that is not turned away: n less its part against v (BM-3).
// A normal turned away by a bump would be black, and mirror what is behind the surface. Continuous: where n.v passes 0 nothing is taken off.
//   n, v       unit; geometric: unit, the face's own on the side that is seen
//   returns a unit vector with n.v >= -4 u; geometric where n is opposite to v to 2^-20, which n.geometric > 0 rules out
// (kernel test KeepFacing)
vec3 keep_facing(vec3 n, vec3 geometric, vec3 v) {
    float nv = dot(n, v);
    vec3 along = n - v * min(nv, 0.0);
    bool lost = dot(along, along) < 9.094947e-13; // 2^-40: the square of 2^-20, where rounding begins to choose the direction
    vec3 edge = fast_normalize(lost ? geometric : along);
    edge -= v * min(dot(edge, v), 0.0); // the normalisation has stretched the rounding of a short one
    return nv >= 0.0 ? n : edge;
}

// Two unit vectors that make a right-handed frame with n. Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin 2017, "Building an
// orthonormal basis, revisited", JCGT 6(1), listing 3. The first one is returned.
vec3 any_tangent(vec3 n) {
    float s = n.z < 0.0 ? -1.0 : 1.0, a = -1.0 / (s + n.z);
    return vec3(1.0 + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}

// The frame about n whose first axis is the direction of t along the surface: Gram and Schmidt, twice ("twice is enough": Parlett 1980,
// "The symmetric eigenvalue problem", sec. 6.9), or any_tangent where t vanishes, is not finite or is along n (BM-2).
//   n           unit to 2 u
//   t           anything; of length 2^-126 and up
//   handedness  < 0: bb = -(n x tt), as where uv is mirrored
//   tt, bb      unit, orthogonal to each other and to n within 4 u (kernel test TangentFrame)
void tangent_frame(vec3 n, vec3 t, float handedness, out vec3 tt, out vec3 bb) {
    vec3 fallback = any_tangent(n);
    vec3 w = safe_normalize(t, fallback);
    vec3 once = w - n * dot(n, w);
    once = dot(once, once) > 9.094947e-13 ? once : fallback; // within 2^-20 of n what is left is mostly rounding: 2^-23 of w and of n
    once = fast_normalize(once);
    tt = safe_normalize(once - n * dot(n, once), fallback);
    bb = safe_normalize(cross(n, tt), fallback);
    bb = handedness < 0.0 ? -bb : bb;
}

// Surface gradient of a normal map.
// Mikkelsen 2020, eq. 5: the slopes are -x/z and -y/z; z is taken as at least 1/128 of the larger of |x| and |y|, so slopes end at 128.
//   texel    in [0, 1]; 0.5 is 0, y points along +v (green up, as in glTF 2.0, 3.9.3)
//   scale    of x and y
//   t, b     the directions in which u and v grow along the surface: unit vectors
vec3 normal_map_gradient(vec3 texel, float scale, vec3 t, vec3 b) {
    vec3 m = 2.0 * texel - 1.0;
    float z = max(abs(m.z), max(abs(m.x), abs(m.y)) * (1.0 / 128.0));
    vec2 slope = -scale * m.xy / max(z, 1e-30);
    return slope.x * t + slope.y * b;
}

#endif
