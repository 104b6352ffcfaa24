// Rays against triangles, watertight: o + t d in, t and barycentrics out. u = 2^-24.
// Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1): the vertices are sheared into the space where the ray is the
// z axis; each one comes out the same for all its triangles, and so do the signs of the edges, exactly, whichever triangle asks.
#ifndef LIGHTBENCH_LIB_RAY_TRIANGLE
#define LIGHTBENCH_LIB_RAY_TRIANGLE
#include "lib/exact.glsl"
#include "lib/ray.glsl"

// Once a ray. The axis of the largest |component| becomes z; the cyclic order of the three stays. Vulkan lets quotients be off by 2.5 ulp, with
// what is left over divided once more they are off by 1 u: the origins of next rays need not be as far away for that.
struct RayShear {
    bool x_is_z, y_is_z;
    vec3 by; // what is taken from x and y for each z; t for each z
};

vec3 permuted(RayShear s, vec3 v) { return s.x_is_z ? v.yzx : s.y_is_z ? v.zxy : v; }

RayShear shear_of(vec3 d) {
    vec3 m = abs(d);
    RayShear s;
    s.x_is_z = m.x >= m.y && m.x >= m.z;
    s.y_is_z = !s.x_is_z && m.y >= m.z;
    vec3 p = permuted(s, d);
    precise vec3 quotient = vec3(p.xy, 1.0) / p.z;
    precise vec3 product = quotient * p.z;
    precise vec3 rest = (vec3(p.xy, 1.0) - product) - product_error(quotient, vec3(p.z));
    precise vec3 once_more = quotient + rest / p.z;
    s.by = once_more;
    return s;
}

// x and y of a vertex relative to the ray, z along the shear axis. `precise`: the same bits for every triangle of a vertex and in every shader.
vec3 sheared(RayShear s, vec3 v, vec3 o) {
    precise vec3 q = v - o;
    precise vec3 p = permuted(s, q);
    precise vec2 xy = p.xy - s.by.xy * p.z;
    return vec3(xy, p.z);
}

// First meeting of a ray with a triangle, from either side.
//   s, o     shear_of(d), origin; d of any length
//   after    t is larger than this
//   b        barycentrics of v1 and v2
//   returns t, or kNoHit. A triangle in whose plane the ray lies is missed, and one with two equal vertices. Others without area must not get
//            here (PL-2: the loader drops them): what rounding makes of them may be hit.
// Watertight: products that differ after rounding differ that way before it, so the sign of an edge function is exact where it is not 0, and 0
// counts as inside on both sides of the edge: rounding never takes a ray out of both triangles. One that passes an edge within u of its
// products may hit both; the paper's doubles decide more of these, for the price of a second intersection where an `if` runs both sides.
// t is a mean of the vertices' t: above 0 where these are, whatever happens. Where they are on both sides of the origin, the determinant
// e.z = t (e.x + e.y + e.z) must be larger than the rounding of what it is made of: u of both products of an edge function, u of their
// difference, 3 u of the sum (PL-6; Pharr, Jakob, Humphreys 2023, "Physically based rendering", 4th ed., sec. 6.8.7, bound it by the largest
// coordinates, several times as much, and surfaces that are some floats apart become one: SH-4). What rounding does to the vertices is in the
// error of triangle_point.
// Error of t: 6 u of the largest coordinate relative to o, over the cosine of incidence; and 6 u of the products over the sum of the edge
// functions, of the range of the vertices' t: much only for thin triangles and grazing rays.
float ray_triangle(RayShear s, vec3 o, vec3 v0, vec3 v1, vec3 v2, float after, out vec2 b) {
    vec3 p0 = sheared(s, v0, o), p1 = sheared(s, v1, o), p2 = sheared(s, v2, o);
    vec3 x = vec3(p0.x, p1.x, p2.x), y = vec3(p0.y, p1.y, p2.y), z = vec3(p0.z, p1.z, p2.z);
    precise vec3 p = x.zxy * y.yzx, q = y.zxy * x.yzx;
    precise vec3 e = p - q; // of the edges opposite to v0, v1, v2
    bool inside = all(greaterThanEqual(e, vec3(0.0))) || all(lessThanEqual(e, vec3(0.0)));
    bool around = min(z.x, min(z.y, z.z)) <= 0.0 && max(z.x, max(z.y, z.z)) >= 0.0;
    float volume = dot(e, z), inverse = 1.0 / (e.x + e.y + e.z);
    float least = around ? gamma(1.0) * dot(abs(p) + abs(q) + 4.0 * abs(e), abs(z)) : 0.0;
    float t = volume * inverse * s.by.z; // no area: infinite or NaN
    b = e.yz * inverse;
    return inside && abs(volume) > least && t > after && t < kNoHit ? t : kNoHit;
}

// The point with these barycentrics, and how far off it is for a next ray: offset_origin takes it to where the triangle is not met again.
// Error of every coordinate, three parts. To the plane (PL-5): a product and two sums for each vertex, gamma(3) sum |b v|; the weight of v0
// is off by u at most, and its share by u |v0|. And ray_triangle moves vertices relative to the origin by 2 u |x| + 4 u |z| (a difference each;
// a quotient, a product, a difference), when the next ray starts at this point.
vec3 triangle_point(vec3 v0, vec3 v1, vec3 v2, vec2 b, out vec3 error) {
    vec3 p0 = (1.0 - b.x - b.y) * v0, p1 = b.x * v1, p2 = b.y * v2, p = p0 + p1 + p2;
    vec3 reach = max(abs(v0 - p), max(abs(v1 - p), abs(v2 - p)));
    error = gamma(4.0) * (abs(p0) + abs(p1) + abs(p2)) + gamma(1.0) * abs(v0);
    error += gamma(2.0) * reach + gamma(4.0) * max(reach.x, max(reach.y, reach.z));
    return p;
}

#endif
