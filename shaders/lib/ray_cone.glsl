// Rays and truncated cones about z between z = -1 and z = 1, of radius r0 and r1 there, the larger one 1; r0 = r1 = 1 is the cylinder.
// A ray in the space of the shape in, its t and the part that it hits out: 0 the mantle, 1 the cap at z = -1, 2 the cap at 1. u = 2^-24.
#ifndef LIGHTBENCH_LIB_RAY_CONE
#define LIGHTBENCH_LIB_RAY_CONE
#include "lib/local_ray.glsl"

const float kConeReach = 1.4142137;

// Parameters of a line between which it is inside; the first is larger where it is nowhere.
vec2 everywhere_if(bool inside) { return inside ? vec2(-kNoHit, kNoHit) : vec2(kNoHit, -kNoHit); }

// Where the line z + s vz is in [-1, 1], ends included. A vz below 2^-60 moves z by less than 2^-36 u within reach: it counts as 0.
vec2 slab_interval(float z, float vz) {
    bool along = abs(vz) < 8.6736174e-19;
    float inverse = 1.0 / (along ? 1.0 : vz);
    vec2 s = vec2(-1.0 - z, 1.0 - z) * inverse;
    return along ? everywhere_if(abs(z) <= 1.0) : vec2(min(s.x, s.y), max(s.x, s.y));
}

// From q, which is near a root of the line, to the root itself. Near the apex, and along the mantle, a, b and c are small differences of
// large numbers; those at q are as small as q is near.
//   a        of the quadratic; half_gap  sqrt(b^2 - a c), the same at every point of a line, below 0 for the root where the line goes in
//   returns 0 where the other root is so near that q may belong to either
float mantle_correction(vec3 q, vec3 v, float mean, float slope, float a, float half_gap) {
    float rho = mean + slope * q.z, r = length(q.xy);
    float b = dot(q.xy, v.xy) - rho * (slope * v.z), c = (r - rho) * (r + rho);
    float both = half_gap < 0.0 ? half_gap + min(b, 0.0) : half_gap + max(b, 0.0);
    return 4.0 * abs(a * c) < half_gap * half_gap ? -c / both : 0.0;
}

// Where the line p + s v is inside the nappe x^2 + y^2 <= rho^2, rho = mean + slope z >= 0.
// a s^2 + 2 b s + c <= 0 by the q-form (Press et al. 2007, "Numerical recipes", sec. 5.6), whose smaller root stays where the line is parallel
// to a generator, a = 0 (CO-2). Its discriminant b^2 - a c is, by Lagrange's identity for x^2 + y^2 - rho^2, |rho v - p rho'|^2 - |p x v|^2
// in the xy plane: two distances from the line, each good to u, instead of two squares that cancel (CY-2). Along a generator it is the other
// way round: a, b and c are good to u and small, the distances are not. Whichever is the smaller sum loses less.
// a < 0: the line meets each nappe once, and is inside this one where rho grows (CO-1). a > 0: it meets one nappe, maybe the other one,
// which ends where the slab begins. Lines along the axis of a cylinder have neither a nor b (CY-1): below 2^-40, the direction across the
// axis moves nothing by u.
vec2 mantle_interval(vec3 p, vec3 v, float mean, float slope) {
    float rho = mean + slope * p.z, growth = slope * v.z;
    float across = abs(p.x * v.y - p.y * v.x), reach = length(rho * v.xy - growth * p.xy);
    float side = length(v.xy), r = length(p.xy);
    float a = (side - abs(growth)) * (side + abs(growth));
    a = a == 0.0 ? -7.8886091e-31 : a; // 2^-100: puts the second root where no slab is
    float b = dot(p.xy, v.xy) - rho * growth, c = (r - rho) * (r + rho);
    float stretch = reach + across, discriminant = (reach - across) * stretch;
    discriminant = 2.0 * abs(b) + abs(a) + abs(c) < stretch ? b * b - a * c : discriminant;
    float root = sqrt(max(discriminant, 0.0));
    float q = b < 0.0 ? root - b : -root - b;
    float s0 = q / a, s1 = q == 0.0 ? 0.0 : c / q;
    vec2 s = vec2(min(s0, s1), max(s0, s1));
    s = a < 0.0 ? (growth > 0.0 ? vec2(s.y, kNoHit) : vec2(-kNoHit, s.x)) : s;
    s = a > 0.0 && discriminant < 0.0 ? everywhere_if(false) : s;
    if (abs(s.x) < 4.0) s.x += mantle_correction(p + s.x * v, v, mean, slope, a, -root);
    if (abs(s.y) < 4.0) s.y += mantle_correction(p + s.y * v, v, mean, slope, a, root);
    return max(side, abs(growth)) < 9.0949470e-13 ? everywhere_if(c <= 0.0) : s;
}

// The smallest t > after at which o + t d is on the surface, else kNoHit.
// The solid is convex, the nappe cut by the slab: a line is inside between the later of its two entries and the earlier of its two exits,
// so that no ray finds a gap between mantle and caps (CY-2).
//   o, d     as for local_ray
//   r0, r1   in [0, 1], the larger one 1
//   capped   closed by its two discs; else the mantle alone, rims included
//   part     of the hit; the mantle where both are hit at once
// Error: the surface would have to be moved by 12 u (1 + |o|) for o + t d to be on it, and for any other part of the ray to be on the other
// side (kernel tests RayCone...); a cap and the mantle leave no gap at all (kernel test RayConeIsClosed).
float ray_cone(vec3 o, vec3 d, float r0, float r1, bool capped, float after, out uint part) {
    LocalRay ray = local_ray(o, d, kConeReach);
    vec2 side = mantle_interval(ray.p, ray.v, 0.5 * (r0 + r1), 0.5 * (r1 - r0)), slab = slab_interval(ray.p.z, ray.v.z);
    float enter = max(side.x, slab.x), leave = min(side.y, slab.y);
    bool enter_cap = slab.x > side.x, leave_cap = slab.y < side.y, up = ray.v.z > 0.0;
    float t0 = t_of(ray, enter), t1 = t_of(ray, leave);
    bool inside = ray.close && enter <= leave;
    bool first = inside && t0 > after && (capped || !enter_cap), second = inside && t1 > after && (capped || !leave_cap);
    uint enter_part = enter_cap ? (up ? 1u : 2u) : 0u, leave_part = leave_cap ? (up ? 2u : 1u) : 0u;
    part = first ? enter_part : leave_part;
    return first ? t0 : (second ? t1 : kNoHit);
}

// Which way p is from the axis, unit; 0 on it. Error: relative 6 u, 4 of them those that Vulkan allows inversesqrt.
vec2 away_from_axis(vec2 p) {
    vec2 w = p * scale_to_one(largest_magnitude(vec3(p, 0.0)));
    float square = dot(w, w);
    return square > 0.0 ? w * inversesqrt(square) : vec2(0.0);
}

// A computed point of a hit put back onto the part it is on: along the plane of its z, then onto the mantle or into the disc.
//   p        anything finite
// Error: 11 u from the surface (kernel test ConePoint): 6 u of the direction, a product or a sum, 2.5 u of rho.
vec3 cone_point(vec3 p, float r0, float r1, uint part) {
    float z = part == 0u ? clamp(p.z, -1.0, 1.0) : (part == 1u ? -1.0 : 1.0);
    float rho = 0.5 * (r0 + r1) + 0.5 * (r1 - r0) * z;
    vec2 away = away_from_axis(p.xy), onto = rho * (away == vec2(0.0) ? vec2(1.0, 0.0) : away);
    return vec3(part == 0u || dot(p.xy, away) > rho ? onto : p.xy, z);
}

// What leaves from so much above that point never meets the cone again (kernel test RayConeLeaves): the error of the point, and that with
// which the next ray finds the distance between its origin and the mantle, 10 u of a length by Vulkan's square root and 2.5 u of rho.
const float kConeClearance = 24.0 * kRoundoff;

// Outward normal at a point of a part, of length 1 to sqrt(5)/2. The apex, where the mantle has none, gets that of the axis (CO-1).
// Error: relative 6 u of the given point.
vec3 cone_normal(vec3 p, float r0, float r1, uint part) {
    float slope = 0.5 * (r1 - r0);
    vec2 away = away_from_axis(p.xy);
    vec3 mantle = away != vec2(0.0) ? vec3(away, -slope) : vec3(0.0, 0.0, slope > 0.0 ? -1.0 : 1.0);
    return part == 0u ? mantle : vec3(0.0, 0.0, part == 1u ? -1.0 : 1.0);
}

#endif
