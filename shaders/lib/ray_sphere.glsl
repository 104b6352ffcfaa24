// Rays against spheres: o + t d in, t out; the point, its normal and its error where there is a hit. u = 2^-24.
// Haines, Guenther, Akenine-Moeller 2019, "Precision improvements for ray/sphere intersection", Ray Tracing Gems, ch. 7: the discriminant
// from the distance between centre and line, the nearer root as c / q. b^2 - 4 a c misses a third of the rays from 10^4 radii away (SP-1).
#ifndef LIGHTBENCH_LIB_RAY_SPHERE
#define LIGHTBENCH_LIB_RAY_SPHERE
#include "lib/exact.glsl"
#include "lib/ray.glsl"

// The smaller root above `after` of t^2 a - 2 t b + c = 0, where discriminant = (b^2 - a c) / a^2 * a. NaN of any argument: no root.
// q has the sign of b, so that nothing is subtracted; where q is 0 both roots are 0 and c / q, a NaN, fails its comparison (SP-3).
float first_root(float a, float b, float c, float discriminant, float after) {
    float root = sqrt(max(discriminant, 0.0));
    float q = b < 0.0 ? b - root : b + root;
    float t0 = c / q, t1 = q / a;
    float near = b < 0.0 ? t1 : t0, far = b < 0.0 ? t0 : t1;
    float t = near > after ? near : far > after ? far : kNoHit;
    return discriminant >= 0.0 ? min(t, kNoHit) : kNoHit;
}

// First meeting of a ray with a sphere.
//   d        unit to 6 u
//   c, r     centre, radius > 0
//   after    the root is larger than this
//   returns t, or kNoHit; inside the sphere, the way out
// Error: hit or miss as in real arithmetic unless the line passes within 8 u |c - o| of the tangent; t to 8 u |c - o| / cos(incidence)
// (kernel test RaySphere).
float ray_sphere(vec3 o, vec3 d, vec3 c, float r, float after) {
    vec3 f = c - o;
    float a = dot(d, d), b = dot(f, d);
    vec3 l = f - b * (2.0 - a) * d; // 1 / a = 2 - a to (a - 1)^2 = 144 u^2; without it 12 u b d would stay in l
    return first_root(a, b, dot(f, f) - r * r, a * (r * r - dot(l, l)), after);
}

// The t that ray_sphere found, for origins nearer to the surface than r / 256, where its 8 u |c - o| are not small: a camera above a ground
// of 10^6 radii (SP-2). One step of Newton, the height over the sphere in twice the digits; once a ray. Others stay as they are.
// Error: relative 8 u / cos(incidence)^2 where a step improves anything (kernel test NearSphere).
float near_sphere(vec3 o, vec3 d, float t, vec3 c, float r) {
    float power = exact_power(c, o, r), a = dot(d, d), b = dot(c - o, d);
    float slope = 2.0 * (a * t - b);
    return abs(power) < 0.0078125 * r * r && abs(slope) > 0.0 ? t - (power + t * (a * t - 2.0 * b)) / slope : t;
}

// The point that ray_sphere found, brought back onto the sphere: o + t d is off by u t, far more than u r for a distant sphere.
//   n        outward unit normal
//   error    every coordinate of the point is this near to the same point of the sphere
// Error of the point along n: r n has the length of n, 6 u, and a rounding; the sum has another one of |p|. Two u r more cover the rounding of
// c - p and of |c - p|^2 when the next ray is intersected: from offset_origin outwards it does not meet this sphere (SP-4).
vec3 sphere_point(vec3 o, vec3 d, float t, vec3 c, float r, out vec3 n, out vec3 error) {
    vec3 g = t * d - (c - o);
    n = dot(g, g) > 0.0 ? fast_normalize(g / r) : -d;
    vec3 p = c + r * n;
    error = gamma(9.0) * abs(r * n) + gamma(1.0) * abs(p);
    return p;
}

// First meeting with the unit sphere about 0, for ellipsoids: the ray in the shape's own space, where t is still the world's.
//   d        any length above 2^-126: a power of two brings it to [1, 4), which changes no bit of the others
//   returns t > after, or kNoHit
float ray_ball(vec3 o, vec3 d, float after) {
    float scale = scale_to_one(largest_magnitude(d));
    d *= scale;
    float a = dot(d, d), b = -dot(o, d);
    vec3 l = o + (b / a) * d;
    float t = first_root(a, b, dot(o, o) - 1.0, a * (1.0 - dot(l, l)), after / scale);
    return t < kNoHit ? t * scale : kNoHit;
}

// The point that ray_ball found, on the unit sphere: it is its own outward normal there. error: gamma(9) |q|, as in sphere_point.
vec3 ball_point(vec3 o, vec3 d, float t, out vec3 error) {
    vec3 q = fast_normalize(o + t * d);
    error = gamma(9.0) * abs(q);
    return q;
}

#endif
