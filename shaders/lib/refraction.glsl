// Directions of mirrored and refracted rays. Unit vectors in and out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_REFRACTION
#define LIGHTBENCH_LIB_REFRACTION
#include "lib/environment.glsl"
#include "lib/fresnel.glsl"

// One Newton step on |d| = 1, so that a direction that went over a thousand surfaces is still unit (RF-3).
// Error: | |d| - 1 | <= 3 u for | |d| - 1 | <= 1e-4 before.
vec3 unit_again(vec3 d) { return d + d * (0.5 * (1.0 - dot(d, d))); }

// The direction i after a mirror, i - 2 (i.n) n.
//   i        unit to 4 u, towards the surface
//   n        either side, of any length in [1e-15, 1e18] (EN-3)
// Error: | |d| - 1 | <= 4 u, 8 u from the mirror direction (kernel test MirrorDirection).
vec3 mirror_direction(vec3 i, vec3 n) { return unit_again(reflected(n, -i)); }

// The direction i after a refracting surface; false where all is reflected.
// Snell's law (Huygens 1690, "Traite de la lumiere") as a vector: eta t = i - (g - c) n, c = -i.n, g = sqrt(eta^2 - 1 + c^2), and
// g - c = (eta^2 - 1)/(c + g), so that nothing of equal size is subtracted near eta = 1. Total reflection is where g^2 is not above 0, to
// the last digit of c and eta, as fresnel() has it (RF-2). The built-in refract() takes 1/eta, and returns 0 there.
//   i        unit to 4 u, towards the surface
//   n        unit to 6 u, on the side of i: c >= 0, less is taken as 0
//   eta      index of refraction, transmitted over incident side, in [1e-9, 1e9]; 1 gives i itself
//   t        where false: 0
// Error: | |t| - 1 | <= 4 u; 4 u / cos(angle to -n) from the refracted direction for n unit to 2 u, 8 u / (eta cos) for eta < 1
// (kernel tests RefractedDirection, TotalReflection).
bool refracted_direction(vec3 i, vec3 n, float eta, out vec3 t) {
    float c = -dot(i, n);
    c = c < 0.0 ? 0.0 : c;
    float m = (eta - 1.0) * (eta + 1.0);
    float k = eta < 1.0 ? refracted_square(c, eta) : m + c * c;
    float g = sqrt(k > 0.0 ? k : 1.0);
    bool passes = k > 0.0 || m == 0.0;
    t = (i - n * (m / (c + g))) / eta;
    t = m == 0.0 ? i : (passes ? unit_again(t) : vec3(0.0));
    return passes;
}

#endif
