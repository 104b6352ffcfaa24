// Powers of numbers in [0, 1] from additions, multiplications and one division, which every Vulkan device rounds almost alike: pow() may be
// off by n * 2^-21 near 1, where highlights live, because log2() is (Vulkan 1.3, "Precision and operation of SPIR-V instructions").
// u = 2^-24. A NaN goes in and comes out.
#ifndef LIGHTBENCH_LIB_POWER
#define LIGHTBENCH_LIB_POWER

const float kSqrtHalf = 0.70710678;
// ln 2 in two parts: the first has 15 bits, so that its product with an exponent is exact (Cody and Waite 1980, "Software manual for the
// elementary functions", ch. 6).
const float kLn2Hi = 0.693145751953125;
const float kLn2Lo = 1.428606765330187e-06;

// Exponent k of c as 2^k m, m in [sqrt 1/2, sqrt 2); c > 0.
int centred_exponent(float c) { return int(floatBitsToUint(c) + (0x3f800000u - floatBitsToUint(kSqrtHalf))) >> 23; }

// ln(2^k (1 + f)), f in [-0.293, 0.415].
// ln(1 + f) = 2 atanh z = f - z (f - R), z = f / (2 + f), R = 2 atanh(z)/z - 2 (Cody and Waite 1980, ch. 5); R by a minimax polynomial
// in z^2 of relative error 0.02 u of the logarithm (Remez exchange on [0, 0.0295]).
float log_of_parts(int k, float f) {
    float z = f / (2.0 + f);
    float w = z * z;
    float r = w * (0.6666677594184875 + w * (0.399774968624115 + w * 0.298730731010437));
    float e = float(k);
    return e * kLn2Hi + (f + (e * kLn2Lo - z * (f - r)));
}

// ln(1 - s) that keeps the digits of a small s.
//   s        in [0, 1)
// Error: relative 2.5 u, 1.1 u for s < 0.01 (kernel test LogOneMinus). Both 2^-k - 1 and f are exact.
float log_one_minus(float s) {
    int k = centred_exponent(1.0 - s) - 127;
    float p = uintBitsToFloat(uint(127 - k) << 23); // 2^-k
    return log_of_parts(k, (p - 1.0) - s * p);
}

// ln x of a normal x in [2^-126, 1].
// Error: relative 2.5 u (kernel test LogUnit).
float log_unit(float x) {
    int k = centred_exponent(x) - 127;
    return log_of_parts(k, x * uintBitsToFloat(uint(127 - k) << 23) - 1.0);
}

// e^x for x <= 0.
// e^x = 2^k e^r, |r| <= ln(2)/2 (Cody and Waite 1980, ch. 6); e^r by a minimax polynomial of relative error 0.08 u (Remez exchange).
//   returns e^x; exactly 1 at 0; 0 below -87.3, where the result would leave the normal numbers (at e^-87.33)
// Error: relative 3 u (kernel test ExpNegative).
float exp_negative(float x) {
    float t = x < -87.3 ? -87.3 : x; // max() would hide a NaN
    float k = floor(t * 1.4426950 + 0.5);
    float r = (t - k * kLn2Hi) - k * kLn2Lo;
    float p = 0.04166839271783829 + r * (0.008368780836462975 + r * 0.0013814467238262296);
    p = 0.4999999403953552 + r * (0.1666651964187622 + r * p);
    float y = (1.0 + (r + r * r * p)) * uintBitsToFloat(uint(int(k) + 127) << 23);
    return x < -87.3 ? 0.0 : y;
}

#endif
