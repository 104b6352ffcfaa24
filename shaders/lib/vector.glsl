// Lengths and directions of vectors. Vectors in, scalars and unit vectors out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_VECTOR
#define LIGHTBENCH_LIB_VECTOR

// Bits of the largest |component|: unsigned order is the order of magnitudes, and a NaN comes out on top, where max() would lose it.
uint largest_magnitude(vec3 v) {
    uvec3 b = floatBitsToUint(v) & 0x7fffffffu;
    return max(b.x, max(b.y, b.z));
}

// The power of two that brings a vector of this largest magnitude to [1, 4): multiplying by it is exact. The exponent is held to [1, 253]
// so that the power and its reciprocal are normal numbers.
float scale_to_one(uint magnitude) {
    uint e = clamp(magnitude >> 23, 1u, 253u);
    return uintBitsToFloat((254u - e) << 23);
}

// Length that neither overflows nor underflows on the way.
// Blue 1978, "A portable Fortran program to find the Euclidean norm of a vector", with one power of two as the scale.
//   v        finite; |v| in [1e-37, 3e38]
//   returns |v|; infinite only where |v| itself is beyond the largest float; NaN for NaN
// Error: relative 3 u (kernel test SafeLength); on devices that flush denormal numbers, 2^-252 / |v| more (components below 2^-126).
float safe_length(vec3 v) {
    float scale = scale_to_one(largest_magnitude(v));
    vec3 w = v * scale;
    return sqrt(dot(w, w)) / scale;
}

// x in parts whose products are exact: 12 significant bits, and the rest.
vec3 upper_half(vec3 x) { return uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u); }

// Direction of any vector, for normals that may vanish or come in any scale.
// Scaled as safe_length; then one Newton step on 1 - |w|^2, whose squares are exact by Dekker 1971, "A floating-point technique for
// extending the available precision", sec. 5: the step leaves 0.8 u of the 3.5 u of w, rounding the result adds 1 u.
//   v         anything
//   fallback  what stands in for a vector without a direction: all components zero or denormal, or any infinite or NaN
// Error: | |n| - 1 | <= 2 u for |v| in [1e-37, 3e38] (kernel test SafeNormalize). About three times the cost of fast_normalize.
vec3 safe_normalize(vec3 v, vec3 fallback) {
    uint magnitude = largest_magnitude(v);
    vec3 w = v * scale_to_one(magnitude);
    w /= sqrt(dot(w, w));
    precise vec3 hi = upper_half(w);
    precise vec3 lo = w - hi;
    precise vec3 square = hi * hi;
    precise vec3 rest = (hi + w) * lo; // w^2 - hi^2
    precise float missing = (((1.0 - square.x) - square.y) - square.z) - (rest.x + rest.y + rest.z);
    precise vec3 n = w + w * (0.5 * missing);
    return magnitude - 0x00800000u < 0x7f000000u ? n : fallback; // one comparison: what is below 2^-126 wraps around
}

// Direction of a vector known to be of ordinary length, as interpolated normals and distances in frame units are.
//   v        |v| in [1e-15, 1e18]: squares of components that the device may flush as denormal are below u |v|^2
//   returns v / |v|; NaN for zero, which is outside the domain
// Error: | |n| - 1 | <= 6 u with the 2 ulp that Vulkan allows inversesqrt (kernel test FastNormalize).
vec3 fast_normalize(vec3 v) { return v * inversesqrt(dot(v, v)); }

#endif
