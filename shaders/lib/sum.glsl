// A running sum of colours that does not stall: what each addition rounds off is carried along. vec3 in, vec3 out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_SUM
#define LIGHTBENCH_LIB_SUM

struct Sum3 {
    vec3 total; // rounded sum
    vec3 carry; // sum of what the roundings took
};

Sum3 sum_start() { return Sum3(vec3(0.0), vec3(0.0)); }

// Adds x. Ogita, Rump, Oishi 2005, "Accurate sum and dot product", algorithm 4.3 (Sum2), with the two-sum of Knuth 1969, "The art of
// computer programming" vol. 2, sec. 4.2.2, theorem B: no branch, no comparison of magnitudes.
// `precise`: by the rules of real numbers every carry is 0, and a compiler free to use them removes it.
// Error of sum_result: relative 8 u for 10^6 terms of one sign, 2 u and (count u)^2 in theory (kernel test CompensatedSum). A sum that
// overflows is not finite, though it may be NaN instead of infinite.
void sum_add(inout Sum3 s, vec3 x) {
    precise vec3 total = s.total + x;
    precise vec3 added = total - s.total;
    precise vec3 lost = (s.total - (total - added)) + (x - added);
    precise vec3 carry = s.carry + lost;
    s.total = total;
    s.carry = carry;
}

vec3 sum_result(Sum3 s) {
    precise vec3 result = s.total + s.carry;
    return result;
}

#endif
