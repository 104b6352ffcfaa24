// Rays against boxes: the box [-1, 1]^3 as a shape, and any box as a bound of what is inside it. o + t d in, t out; u = 2^-24.
// Kay, Kajiya 1986, "Ray tracing complex scenes", SIGGRAPH: three slabs; the ray is in the box while it is in all of them.
#ifndef LIGHTBENCH_LIB_RAY_BOX
#define LIGHTBENCH_LIB_RAY_BOX
#include "lib/ray.glsl"

// First meeting of a ray with the cube [-1, 1]^3, for boxes in their own space, where t is still the world's.
//   d        any length; components that are 0, of either sign, leave the slab to the origin: on its plane is inside (BX-1)
//   face     2 axis + (positive side ? 1 : 0): the slab that gave the root, the first one of equals (BX-2, BX-3)
//   returns t > after, of the way in, else of the way out, else kNoHit; NaN: kNoHit
// Error: relative 7 u of t (kernel test RayCube); signs of 1 - |o| are exact, so no ray from outside leaves and hits, none from inside misses.
float ray_cube(vec3 o, vec3 d, float after, out uint face) {
    bvec3 still = lessThan(abs(d), vec3(1.17549435e-38)); // 0, and what a device may take for it
    vec3 side = mix(vec3(-1.0), vec3(1.0), greaterThanEqual(d, vec3(0.0)));
    vec3 inverse = 1.0 / mix(d, vec3(1.0), still);
    vec3 open = mix(vec3(-kNoHit), vec3(kNoHit), lessThanEqual(abs(o), vec3(1.0)));
    vec3 into = mix((-side - o) * inverse, -open, still), away = mix((side - o) * inverse, open, still);
    uint first = into.y > into.x ? 1u : 0u, last = away.y < away.x ? 1u : 0u;
    float enter = max(into.x, into.y), leave = min(away.x, away.y);
    first = into.z > enter ? 2u : first;
    last = away.z < leave ? 2u : last;
    enter = max(enter, into.z);
    leave = min(leave, away.z);
    bool outside = enter > after;
    float t = outside ? enter : leave;
    face = outside ? first : last;
    bool forward = (face == 0u ? side.x : face == 1u ? side.y : side.z) > 0.0;
    face = 2u * face + (forward != outside ? 1u : 0u);
    bool meets = all(lessThanEqual(into, vec3(leave))) && all(lessThanEqual(vec3(enter), away)); // every slab by itself: a NaN fails
    return meets && t > after && t < kNoHit ? t : kNoHit;
}

// The outward normal of a face of the cube.
vec3 cube_normal(uint face) {
    float side = (face & 1u) == 1u ? 1.0 : -1.0;
    return face < 2u ? vec3(side, 0.0, 0.0) : face < 4u ? vec3(0.0, side, 0.0) : vec3(0.0, 0.0, side);
}

// The point that ray_cube found: on its face exactly, so its error along the normal is 0.
vec3 cube_point(vec3 o, vec3 d, float t, uint face) {
    vec3 n = cube_normal(face);
    return mix(clamp(o + t * d, vec3(-1.0), vec3(1.0)), n, notEqual(n, vec3(0.0)));
}

// 1 / d for slabs, never infinite: components below 2^-100 count as 2^-100, for 0 times infinity is NaN where the origin is on a plane.
// Over a way t the ray is taken to be off by 2^-100 t at most, which the margin of BoxRay covers.
vec3 safe_inverse(vec3 d) {
    vec3 m = max(abs(d), vec3(7.8886091e-31));
    return 1.0 / mix(m, -m, lessThan(d, vec3(0.0)));
}

// A ray for boxes that bound shapes. Once a ray.
struct BoxRay {
    vec3 below, above; // the origin less and plus a margin
    vec3 inverse;      // safe_inverse(d)
};

// The margin m = 64 u R makes every box larger by m on all sides, with R = extent + max |o| >= every |coordinate| of a vertex relative to o.
// No box is missed that holds a shape which one of these functions hits, or that the ray only touches:
//   ray_triangle  decides about vertices that are off by 2 u |x| + 4 u |z|, and by u of products beside an edge: 8 u R
//   ray_sphere    takes the line for another one within 8 u |c - o| <= 14 u R; the point at its t is on a sphere no farther off
//   box           made of rounded sums like c - r: u R
//   o -+ m        u R
//   slab          a difference u, a quotient 5 u (Vulkan's 2.5 ulp), a product u: of a plane's distance, 7 u R
// together 23 u R; the rest is for t of triangles, 24 u R where four times the sum of the edge functions is above their products. t of a
// thinner one may be earlier than its box: where another surface lies between the two, it may be found first.
//   d       unit; extent  largest |coordinate| of the boxes
BoxRay box_ray(vec3 o, vec3 d, float extent) {
    float margin = 64.0 * kRoundoff * (extent + max(abs(o.x), max(abs(o.y), abs(o.z))));
    return BoxRay(o - margin, o + margin, safe_inverse(d));
}

// Where the ray enters a box, at 0 or later and up to t_max, or kNoHit. Bounds as said above; t_max itself still counts.
// Not lo * inverse - o * inverse, one multiply-add a plane: its error is u |o * inverse|, unbounded in t where d has small components.
float slab(BoxRay ray, vec3 lo, vec3 hi, float t_max) {
    vec3 a = (lo - ray.above) * ray.inverse, b = (hi - ray.below) * ray.inverse;
    vec3 into = min(a, b), away = max(a, b);
    float enter = max(max(into.x, into.y), max(into.z, 0.0)), leave = min(min(away.x, away.y), min(away.z, t_max));
    return enter <= leave ? enter : kNoHit;
}

#endif
