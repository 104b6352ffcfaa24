// What rounding takes from sums and products, exactly: for the few places where a sign or a small difference of large numbers decides.
// `precise`: by the rules of real numbers all of these are 0. u = 2^-24; numbers in [2^-100, 2^126] or 0 where exactness is claimed.
#ifndef LIGHTBENCH_LIB_EXACT
#define LIGHTBENCH_LIB_EXACT
#include "lib/ray.glsl"
#include "lib/vector.glsl"

// x + y less its rounded sum. Knuth 1969, "The art of computer programming", vol. 2, sec. 4.2.2, theorem B.
vec3 sum_error(vec3 x, vec3 y) {
    precise vec3 s = x + y;
    precise vec3 z = s - x;
    precise vec3 e = (x - (s - z)) + (y - z);
    return e;
}

// x + y rounded upwards: the least float that is not below the sum.
float sum_upwards(float x, float y) {
    precise float s = x + y;
    return sum_error(vec3(x), vec3(y)).x > 0.0 ? next_up(s) : s;
}

// x y less its rounded product. Dekker 1971, "A floating-point technique for extending the available precision", sec. 5, with halves of 12
// bits by truncation (vector.glsl): all four partial products have 24 bits, and all sums are exact.
vec3 product_error(vec3 x, vec3 y) {
    precise vec3 xh = upper_half(x), yh = upper_half(y), xl = x - xh, yl = y - yh, p = x * y;
    precise vec3 e = (((xh * yh - p) + xh * yl) + xl * yh) + xl * yl;
    return e;
}

// |x - y|^2 - r^2 as if in twice the digits: relative u, absolute 8 u^2 r^2 where it nearly vanishes.
float exact_power(vec3 x, vec3 y, float r) {
    precise vec3 f = x - y;
    vec3 lost = sum_error(x, -y);
    precise vec3 square = f * f;
    precise float rr = r * r;
    precise vec3 rest = product_error(f, f) + 2.0 * f * lost;
    precise float first = square.x - rr, second = first + square.y, third = second + square.z;
    vec3 sums = sum_error(vec3(square.x, first, second), vec3(-rr, square.y, square.z));
    precise float carried = (sums.x + sums.y + sums.z) + ((rest.x + rest.y + rest.z) - product_error(vec3(r), vec3(r)).x);
    return third + carried;
}

#endif
