// Rays against triangles, watertight: o + t d in, t and barycentrics out. u = 2^-24.
// Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1): the vertices are sheared into the space where the ray is the
// z axis; each one comes out the same for all its triangles, and so do the signs of the edges, exactly, whichever triangle asks.
#ifndef LIGHTBENCH_LIB_RAY_TRIANGLE
#define LIGHTBENCH_LIB_RAY_TRIANGLE
#include "lib/ray.glsl"
#include "lib/vector.glsl"

// Once a ray. The axis of the largest |component| becomes z; the cyclic order of the three stays.
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
    s.by = vec3(p.x / p.z, p.y / p.z, 1.0 / p.z);
    return s;
}

// x and y of a vertex relative to the ray, z along the shear axis. `precise`: the same bits for every triangle of a vertex and in every shader.
vec3 sheared(RayShear s, vec3 v, vec3 o) {
    precise vec3 q = v - o;
    precise vec3 p = permuted(s, q);
    precise vec2 xy = p.xy - s.by.xy * p.z;
    return vec3(xy, p.z);
}

// x y less its rounded product: exact. Dekker 1971, "A floating-point technique for extending the available precision", sec. 5, with halves
// of 12 bits by truncation (vector.glsl): all four partial products have 24 bits, all sums are exact while |x y| > 2^-100.
vec3 product_error(vec3 x, vec3 y) {
    precise vec3 xh = upper_half(x), yh = upper_half(y), xl = x - xh, yl = y - yh, p = x * y;
    precise vec3 e = (((xh * yh - p) + xh * yl) + xl * yh) + xl * yl;
    return e;
}

// Edge functions u v - w x whose rounded products are equal: the difference of their errors, which has the right sign.
// Where the products differ the sign of the difference is right by itself, for rounding is monotonic. (In place of the paper's doubles.)
vec3 exact_edges(vec3 e, vec3 u, vec3 v, vec3 w, vec3 x) {
    precise vec3 exact = product_error(u, v) - product_error(w, x);
    return mix(e, exact, equal(e, vec3(0.0)));
}

// The largest t that rounding may make out of 0. After Pharr, Jakob, Humphreys 2023, "Physically based rendering", 4th ed., sec. 6.8.7, but
// with a bound for every product instead of one for the largest: surfaces some floats apart stay two (SH-4).
//   x, y, z  of the three vertices, sheared; e  edge functions
// z is off by u |z|, x by 2 u |x| + 3 u |z|, y likewise: differences, a product, a difference. What s.by is off by turns the ray a little about
// its origin, which does not move that to the other side of the plane.
float t_error(vec3 x, vec3 y, vec3 z, vec3 e, float t_of_z, float inverse_area) {
    vec3 mx = abs(x), my = abs(y), mz = abs(z);
    vec3 dx = 2.0 * mx + 3.0 * mz, dy = 2.0 * my + 3.0 * mz;
    vec3 de = dx.zxy * my.yzx + mx.zxy * dy.yzx + dy.zxy * mx.yzx + my.zxy * dx.yzx + 2.0 * (mx.zxy * my.yzx + my.zxy * mx.yzx);
    return gamma(1.0) * dot(de + 4.0 * abs(e), mz) * abs(t_of_z * inverse_area);
}

// First meeting of a ray with a triangle, from either side.
//   s, o     shear_of(d), origin; d of any length
//   after    t is larger than this
//   b        barycentrics of v1 and v2
//   returns t, or kNoHit. A ray through an edge or a vertex hits every triangle there. Triangles with two equal vertices are missed, and so
//            are those seen edge on; other triangles without area must not get here (PL-2: they are found when a scene is loaded).
// t is a mean of the vertices' t: above 0 where these are. Elsewhere it must be above its error, or it is no hit (PL-6). That, and edges
// of 0, are rare: a loop without iterations, since an `if` runs both sides on some drivers.
float ray_triangle(RayShear s, vec3 o, vec3 v0, vec3 v1, vec3 v2, float after, out vec2 b) {
    vec3 p0 = sheared(s, v0, o), p1 = sheared(s, v1, o), p2 = sheared(s, v2, o);
    vec3 x = vec3(p0.x, p1.x, p2.x), y = vec3(p0.y, p1.y, p2.y), z = vec3(p0.z, p1.z, p2.z);
    precise vec3 e = x.zxy * y.yzx - y.zxy * x.yzx; // of the edges opposite to v0, v1, v2
    bool inside = all(greaterThanEqual(e, vec3(0.0))) || all(lessThanEqual(e, vec3(0.0)));
    bool around = min(z.x, min(z.y, z.z)) <= 0.0 && max(z.x, max(z.y, z.z)) >= 0.0;
    float least = after;
    for (bool rare = inside && (around || any(equal(e, vec3(0.0)))); rare; rare = false) {
        e = exact_edges(e, x.zxy, y.yzx, y.zxy, x.yzx);
        inside = all(greaterThanEqual(e, vec3(0.0))) || all(lessThanEqual(e, vec3(0.0)));
        least = around ? max(after, t_error(x, y, z, e, s.by.z, 1.0 / (e.x + e.y + e.z))) : after;
    }
    float inverse = 1.0 / (e.x + e.y + e.z);
    b = e.yz * inverse;
    float t = dot(e, z) * inverse * s.by.z; // no area: infinite or NaN
    return inside && t > least && t < kNoHit ? t : kNoHit;
}

// The point with these barycentrics, and how far each of its coordinates may be from the plane of the vertices (PL-5).
// Three products and two sums: gamma(3) sum |b v|, gamma(7) as in Pharr et al., sec. 6.8.5; the weight of v0 is off by u, and so is v0's share.
vec3 triangle_point(vec3 v0, vec3 v1, vec3 v2, vec2 b, out vec3 error) {
    vec3 p0 = (1.0 - b.x - b.y) * v0, p1 = b.x * v1, p2 = b.y * v2;
    error = gamma(7.0) * (abs(p0) + abs(p1) + abs(p2)) + gamma(1.0) * abs(v0);
    return p0 + p1 + p2;
}

#endif
