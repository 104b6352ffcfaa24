// The last steps of a colour: census of non-finite values, sRGB encoding, 8 bits. Linear colours in, encoded ones out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_COLOR
#define LIGHTBENCH_LIB_COLOR
#include "lib/power.glsl"

// By the bits: compilers may assume that isnan() and isinf() are never true. Ask before any clamp(), min() or max(): they hide a NaN.
bool is_finite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }
bool non_finite(vec4 c) { return any(equal(floatBitsToUint(c) & 0x7f800000u, uvec4(0x7f800000u))); }

// Transfer function of one channel.
// IEC 61966-2-1:1999, sec. 5.2: 12.92 x up to 0.0031308, above 1.055 x^(1/2.4) - 0.055; pow() would cost 3e-4 of an 8-bit step.
//   x        linear, clamped to [0, 1]; NaN counts as 0 (the census has seen it)
// Error: absolute 5 u, 8e-5 of an 8-bit step (kernel test SrgbEncode).
float srgb_encode(float x) {
    float c = x > 0.0 ? min(x, 1.0) : 0.0;
    float curve = 1.055 * exp_negative(log_unit(max(c, 0.0031308)) * (1.0 / 2.4)) - 0.055;
    return c <= 0.0031308 ? 12.92 * c : curve;
}

vec3 srgb_encode(vec3 linear) { return vec3(srgb_encode(linear.r), srgb_encode(linear.g), srgb_encode(linear.b)); }

// Nearest of 256 steps, round(255 x); halves go up.
//   x        clamped to [0, 1]; NaN counts as 0
// Error: within 1/2 + 1e-4 step of 255 x, and exact outside 1e-4 step of a tie (kernel test Quantize8).
uint quantize8(float x) {
    float c = x > 0.0 ? min(x, 1.0) : 0.0;
    return uint(floor(c * 255.0 + 0.5));
}

#endif
