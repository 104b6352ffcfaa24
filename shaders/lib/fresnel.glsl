// Unpolarised Fresnel reflectance of a smooth dielectric. Cosine and index of refraction in, reflected fraction out; u = 2^-24.
// A NaN goes in and comes out. Where division and square root are rounded, relative errors are 8e-7 and absolute ones 5e-7: Vulkan's take 4 u
// and 8 u more, thus 20 u more of both amplitudes and 40 u of what is returned; 16 u where g < c / 3 has a smaller share in them.
#ifndef LIGHTBENCH_LIB_FRESNEL
#define LIGHTBENCH_LIB_FRESNEL

// Any index with the plain k of fresnel(): the kernel of Cook-Torrance, whose facets are seen from the thinner side.
// Fresnel 1823; the form of Cook and Torrance 1982, "A Reflectance Model for Computer Graphics", sec. 4, rationalised: with m = n^2 - 1,
// k = m + c^2 and g = sqrt(k) the amplitudes are -m/(c+g)^2 and m((n^2+1)c^2 - 1)/(n^2 c + g)^2, so nothing of equal size is subtracted
// near n = 1, where (c-g)/(c+g) loses every digit.
//   c        cosine of the angle of incidence, in [0, 1]
//   n        index of refraction, far side over near side, in [1e-9, 1e9]
//   returns  the reflected fraction in [0, 1]; exactly 0 for n = 1
// Error: relative 3.2e-6 for n >= 1 (kernel test FresnelDense). n < 1: k is off by 3 u, so absolute 2.9e-6 where
// k > 0.1, else 1e-3/n^2 (kernel test FresnelDenseOfThinMedia).
float fresnel_dense(float c, float n) {
    float m = (n - 1.0) * (n + 1.0);
    float n2 = n * n, c2 = c * c;
    float k = m + c2;
    float g = sqrt(k), near = c + g, far = n2 * c + g;
    float s = m / (near * near);
    float p = m * ((n2 + 1.0) * c2 - 1.0) / (far * far);
    float f = 0.5 * (s * s + p * p);
    f = f > 1.0 || k <= 0.0 ? 1.0 : f; // not min(), which hides a NaN; 0/0 where n = 1 and c = 0
    return m == 0.0 ? 0.0 : f;
}

vec3 fresnel_dense(float c, vec3 n) { return vec3(fresnel_dense(c, n.x), fresnel_dense(c, n.y), fresnel_dense(c, n.z)); }

// x^2 as a sum of two floats, exactly (Dekker 1971, "A floating-point technique for extending the available precision", sec. 5).
vec2 exact_square(float x) {
    precise float high = uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u); // 12 bits: products of the parts are exact
    precise float low = x - high;
    precise float square = x * x;
    precise float rest = ((high * high - square) + 2.0 * high * low) + low * low;
    return vec2(square, rest);
}

// a + b as a sum of two floats, exactly (Knuth, "The art of computer programming" vol. 2, sec. 4.2.2, theorem B).
vec2 exact_sum(float a, float b) {
    precise float sum = a + b;
    precise float shift = sum - a;
    precise float rest = (a - (sum - shift)) + (b - shift);
    return vec2(sum, rest);
}

// n^2 + c^2 - 1 for n < 1, whose sign decides about total reflection: the five exact parts are added from the largest down, and where the
// first two come near 1 their difference to 1 is exact (Sterbenz 1974, "Floating-point computation", theorem 4.3.1).
// Error: relative 1.1 u.
float refracted_square(float c, float n) {
    vec2 n2 = exact_square(n), c2 = exact_square(c);
    vec2 sum = exact_sum(n2.x, c2.x), rest = exact_sum(n2.y, c2.y);
    vec2 middle = exact_sum(sum.y, rest.x);
    precise float excess = sum.x - 1.0;
    vec2 top = exact_sum(excess, middle.x);
    precise float k = top.x + (top.y + (middle.y + rest.y));
    return k;
}

// Any index, also from the denser side, where light is reflected totally beyond the critical angle.
// As fresnel_dense; for n < 1 the slope of F has no bound at the critical angle, so k is taken to its last digit. There p = (n^2 c - g)/
// (n^2 c + g) subtracts unequal things, and away from there (n^2+1)c^2 - 1 is k - n^2 (1 - c^2), the first term exact.
//   c        cosine of the angle of incidence, in [0, 1]
//   n        index of refraction, far side over near side, in [1e-9, 1e9]
//   returns  the reflected fraction in [0, 1]; exactly 1 beyond the critical angle, exactly 0 for n = 1
// Error: relative 3.2e-6; for n < 1 and k < 0.1 c^2 absolute 1.5e-6 (kernel test Fresnel).
float fresnel(float c, float n) {
    float m = (n - 1.0) * (n + 1.0);
    float n2 = n * n, c2 = c * c;
    float k = n < 1.0 ? refracted_square(c, n) : m + c2;
    float g = sqrt(k < 0.0 ? 0.0 : k), near = c + g, far = n2 * c + g;
    float s = m / (near * near);
    float polarised = n < 1.0 ? k - n2 * ((1.0 - c) * (1.0 + c)) : (n2 + 1.0) * c2 - 1.0;
    float p = k < 0.1 * c2 ? (n2 * c - g) / far : m * polarised / (far * far);
    float f = 0.5 * (s * s + p * p);
    f = f > 1.0 || k <= 0.0 ? 1.0 : f;
    return m == 0.0 ? 0.0 : f;
}

vec3 fresnel(float c, vec3 n) { return vec3(fresnel(c, n.x), fresnel(c, n.y), fresnel(c, n.z)); }

#endif
