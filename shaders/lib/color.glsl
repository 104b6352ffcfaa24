// The last steps of a colour: census of non-finite values, sRGB encoding, 8 bits. Linear colours in, encoded ones out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_COLOR
#define LIGHTBENCH_LIB_COLOR

// By the bits: compilers may assume that isnan() and isinf() are never true. Ask before any clamp(), min() or max(): they hide a NaN.
bool is_finite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }
bool non_finite(vec4 c) { return any(equal(floatBitsToUint(c) & 0x7f800000u, uvec4(0x7f800000u))); }

// Transfer function of one channel.
// IEC 61966-2-1:1999, sec. 5.2: 12.92 x up to 0.0031308, above 1.055 x^(1/2.4) - 0.055; pow() would cost 3e-4 of an 8-bit step. The curve is
// 1.055 q^(5/3) - 0.055 of q = x^(1/4), a polynomial of degree 8 in q less the middle of its range, interpolated at Chebyshev's nodes (2.1 u).
// A logarithm and an exponential were as exact, and most of the display pass on CPU drivers.
//   x        linear, clamped to [0, 1]; NaN counts as 0 (the census has seen it)
// Error: absolute 5 u, 8e-5 of an 8-bit step, where sqrt() rounds correctly (4.3 u measured); 29 u with the 4.5 ulp that Vulkan allows each of the two: they
// come to 13.5 u of q, and q f'(q) <= 1.76 (kernel test SrgbEncode).
float srgb_encode(float x) {
    float c = x > 0.0 ? min(x, 1.0) : 0.0;
    float t = sqrt(sqrt(max(c, 0.0031308))) - 0.6182725429534912;
    float p = -0.07170478254556656 + t * 0.08092014491558075;
    p = -0.04709502309560776 + t * (0.04127728193998337 + t * p);
    p = -0.12377795577049255 + t * (0.06682680547237396 + t * p);
    p = 1.2761106491088867 + t * (0.6879953145980835 + t * p);
    float curve = 0.4183899462223053 + t * p;
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
