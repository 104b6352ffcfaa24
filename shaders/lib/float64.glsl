// The factors of Phong's illumination model in double, for --precision float64: what float32 costs in accuracy is told against them. Same
// arguments, same special cases as lib/phong.glsl, lib/attenuation.glsl and lib/spot.glsl; u = 2^-24 still is float's.
#ifndef LIGHTBENCH_LIB_FLOAT64
#define LIGHTBENCH_LIB_FLOAT64

// max(0, N.L), as lambert(). A NaN stays one.
// Error: absolute 2^-50 (kernel test Float64Factors, to the rounding of its result to float).
double lambert_float64(dvec3 n, dvec3 l) {
    double c = dot(n, l);
    return c <= 0.0lf ? 0.0lf : c;
}

// ln x of a normal x in (0, 1]; GLSL has no logarithm of doubles.
// x = 2^k m, m in [sqrt 1/2, sqrt 2); ln m = 2 (z + z^3/3 + z^5/5 + ...), z = (m - 1) / (m + 1), |z| < 0.1716: what follows the tenth term is
// below 2^-54 of the sum (Abramowitz and Stegun 1964, "Handbook of mathematical functions", 4.1.27).
double log_unit_float64(double x) {
    const uint kSqrtHalfHigh = 0x3fe6a09eu; // upper word of sqrt 1/2
    uvec2 words = unpackDouble2x32(x);
    int k = int(words.y + (0x3ff00000u - kSqrtHalfHigh)) / 0x100000 - 1023;
    double m = x * packDouble2x32(uvec2(0u, uint(1023 - k) << 20u)); // a NaN stays one
    double z = (m - 1.0lf) / (m + 1.0lf), w = z * z;
    double sum = 1.0lf / 19.0lf;
    sum = 1.0lf / 17.0lf + w * sum, sum = 1.0lf / 15.0lf + w * sum, sum = 1.0lf / 13.0lf + w * sum;
    sum = 1.0lf / 11.0lf + w * sum, sum = 1.0lf / 9.0lf + w * sum, sum = 1.0lf / 7.0lf + w * sum;
    sum = 1.0lf / 5.0lf + w * sum, sum = 1.0lf / 3.0lf + w * sum;
    return double(k) * 0.693147180559945309417lf + 2.0lf * (z + z * w * sum);
}

// e^x for x <= 0; 0 below -87.3 as exp_negative(), where float has no normal number.
// x = k ln 2 + r, |r| <= 0.3466: Taylor's polynomial of degree 12 is right to 2^-52 (remainder r^13 / 13!).
double exp_negative_float64(double x) {
    double t = x < -87.3lf ? -87.3lf : x; // max() would hide a NaN
    double k = floor(t * 1.44269504088896340736lf + 0.5lf), r = t - k * 0.693147180559945309417lf;
    double sum = 1.0lf + r / 12.0lf;
    sum = 1.0lf + r / 11.0lf * sum, sum = 1.0lf + r / 10.0lf * sum, sum = 1.0lf + r / 9.0lf * sum, sum = 1.0lf + r / 8.0lf * sum;
    sum = 1.0lf + r / 7.0lf * sum, sum = 1.0lf + r / 6.0lf * sum, sum = 1.0lf + r / 5.0lf * sum, sum = 1.0lf + r / 4.0lf * sum;
    sum = 1.0lf + r / 3.0lf * sum, sum = 1.0lf + r / 2.0lf * sum, sum = 1.0lf + r * sum;
    double y = sum * packDouble2x32(uvec2(0u, uint(int(k) + 1023) << 20u));
    return x < -87.3lf ? 0.0lf : y;
}

// max(0, R.V)^n, as phong_specular(): Phong 1975, "Illumination for computer generated pictures", eq. 2.
//   n, l, v    unit vectors to 2^-50
// Error for R.V >= 1/2: relative 2^-46 (1 + n), from the rounding of R.V (kernel test Float64Factors, to the rounding of its result to float).
double phong_specular_float64(dvec3 n, dvec3 l, dvec3 v, double shininess) {
    double nl = dot(n, l);
    dvec3 d = 2.0lf * nl * n - (l + v); // R - V
    double s = 0.5lf * dot(d, d);
    double factor = exp_negative_float64(shininess * log_unit_float64(1.0lf - s));
    factor = s >= 1.0lf ? 0.0lf : factor;
    return nl <= 0.0lf ? 0.0lf : factor;
}

// 1 / (d + d0), as attenuation_linear().
// Error: relative 2^-51 (kernel test Float64Factors, to the rounding of its result to float).
double attenuation_linear_float64(double d, double d0) {
    double x = d + d0;
    return 1.0lf / (x < 1e-18lf ? 1e-18lf : x);
}

// 1 / (4 pi d^2), as attenuation_inverse_square().
// Error: relative 2^-50 (kernel test Float64Factors, to the rounding of its result to float).
double attenuation_inverse_square_float64(double d) {
    double x = d < 1e-15lf ? 1e-15lf : d;
    return 1.0lf / (12.5663706143591729539lf * (x * x));
}

// A soft-edged cone, as spot_falloff().
// Error: absolute 2^-48 for cosines that differ by a thousandth or more (kernel test Float64Factors, to the rounding of its result to float).
double spot_falloff_float64(double cos_angle, double cos_outer, double cos_inner) {
    double t = (cos_angle - cos_outer) / (cos_inner - cos_outer); // not chosen below where it is 0/0
    double edge = t * t * (3.0lf - 2.0lf * t);
    double outside = cos_angle <= cos_outer ? 0.0lf : edge;
    return cos_angle >= cos_inner ? 1.0lf : outside;
}

#endif
