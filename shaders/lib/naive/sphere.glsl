// The ray and the sphere by the quadratic formula as it stands in every textbook: a teaching pair of lib/ray_sphere.glsl, used nowhere else.
#ifndef LIGHTBENCH_LIB_NAIVE_SPHERE
#define LIGHTBENCH_LIB_NAIVE_SPHERE
#include "lib/naive/real.glsl"

// Foley, van Dam, Feiner, Hughes 1990, "Computer Graphics", sec. 15.10.1, eqs. 15.17 to 15.19.
// Breaks: b^2 - 4 a c subtracts what both have of |o - c|^2, so that from 10^4 radii away nothing of r^2 is left in it; -b + root does the
// same to the nearer root of a ray that starts close to the sphere.
float naive_sphere(vec3 o, vec3 d, vec3 center, float r, float after) {
    real3 l = real3(o) - real3(center), w = real3(d);
    real a = dot(w, w), b = 2.0 * dot(w, l), c = dot(l, l) - real(r) * real(r);
    real discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return 3.4028235e38;
    real t0 = (-b - sqrt(discriminant)) / (2.0 * a), t1 = (-b + sqrt(discriminant)) / (2.0 * a);
    return t0 > after ? float(t0) : t1 > after ? float(t1) : 3.4028235e38;
}

#endif
