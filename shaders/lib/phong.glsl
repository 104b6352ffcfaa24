// Diffuse and specular factors of Phong's illumination model. Unit vectors in, factors of kd Ip and ks Ip out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_PHONG
#define LIGHTBENCH_LIB_PHONG
#include "lib/power.glsl"

// Diffuse factor max(0, N.L) (Lambert 1760, "Photometria", cosine law).
//   n, l     unit
//   returns a number in [0, 1 + 4 u]; a NaN stays one, which max() would hide
// Error: absolute 3 u (kernel test Lambert).
float lambert(vec3 n, vec3 l) {
    float c = dot(n, l);
    return c <= 0.0 ? 0.0 : c;
}

// (1 - s)^n without the cancellation that 1 - s suffers in float near 1.
//   s        in [0, 1)
//   n        any finite number >= 0
// Error: relative (8 + 2|x|) u, x = n ln(1 - s), for s < 0.01, (8 + 2.5|x|) u above, where the result is a normal number; 0 below it
// (kernel test PowerOneMinus).
float power_one_minus(float s, float n) { return exp_negative(n * log_one_minus(s)); }

// Specular factor max(0, R.V)^n, R = 2 (N.L) N - L; 0 where N.L <= 0, so that no light leaks through from behind.
// Phong 1975, "Illumination for computer generated pictures", eq. 2. 1 - R.V is taken as s = |R - V|^2 / 2: nothing of equal size is
// subtracted from 1, and errors in the lengths of the vectors enter squared. pow(R.V, n) is off by n * 2^-21 ln 2: 1e-4 at n = 300.
//   n, l, v    unit vectors to 6 u
//   shininess  any finite number >= 0; 0: a factor of 1 wherever N.L > 0 and R.V > 0
// Error for R.V >= 1/2: relative (8 + 4|x| + 4 sqrt(2 n |x|)) u, x = n ln(R.V); the last term is the rounding of R, which the angle
// between R and V amplifies. Below, for n >= 1: absolute 16 u (kernel test PhongSpecular).
float phong_specular(vec3 n, vec3 l, vec3 v, float shininess) {
    float nl = dot(n, l);
    vec3 d = 2.0 * nl * n - (l + v); // R - V
    float s = 0.5 * dot(d, d);
    float factor = power_one_minus(s, shininess);
    factor = s >= 1.0 ? 0.0 : factor;
    return nl <= 0.0 ? 0.0 : factor;
}

#endif
