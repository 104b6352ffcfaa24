// A ray seen from a shape of size about 1 at the origin. A ray of any length and distance in; a unit direction and a start close by out.
#ifndef LIGHTBENCH_LIB_LOCAL_RAY
#define LIGHTBENCH_LIB_LOCAL_RAY
#include "lib/ray.glsl"
#include "lib/vector.glsl"

struct LocalRay {
    vec3 p;      // a point of the line, |p| <= 2 reach
    vec3 v;      // unit to 3 u
    float start; // s of p, counted from the origin of the ray in steps of v
    float rate;  // t of a step of v
    bool close;  // the line may come within reach; false for rays that are not finite or have no direction
};

// The line o + t d with its start moved to the point closest to the centre where o is far. A quadratic or quartic about a far start
// subtracts numbers of the size of its square or fourth power, and loses as many digits more than the rounding of o + t d has taken:
// Haines, Guenther, Akenine-Moeller 2019, "Precision improvements for ray/sphere intersection", Ray Tracing Gems ch. 7.
//   o, d     |d| in [1e-37, 1e38], |o| up to 1e18 reach
//   reach    radius about the centre that holds the shape
// Error: p is off the line by 2 u |o| where it was moved, and o itself where |o| <= 2 reach.
LocalRay local_ray(vec3 o, vec3 d, float reach) {
    uint magnitude = largest_magnitude(d);
    float scale = scale_to_one(magnitude);
    vec3 w = d * scale;
    float unit = inversesqrt(dot(w, w));
    LocalRay ray;
    ray.v = w * unit;
    ray.rate = scale * unit;
    bool far = dot(o, o) > 4.0 * reach * reach;
    ray.start = far ? -dot(o, ray.v) : 0.0;
    ray.p = far ? o + ray.v * ray.start : o;
    ray.close = dot(ray.p, ray.p) <= 4.0 * reach * reach && magnitude - 0x00800000u < 0x7f000000u;
    return ray;
}

// What is too far for a float is no hit.
float t_of(LocalRay ray, float s) { return min((ray.start + s) * ray.rate, kNoHit); }

#endif
