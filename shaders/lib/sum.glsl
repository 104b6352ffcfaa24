// A running sum of colours that does not stall: what each addition rounds off is carried along. vec3 in, vec3 out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_SUM
#define LIGHTBENCH_LIB_SUM

struct Sum3 {
    vec3 total; // rounded sum
    vec3 carry; // what the last rounding took from it
};

Sum3 sum_start() { return Sum3(vec3(0.0), vec3(0.0)); }

// Adds x.
// Kahan 1965, "Further remarks on reducing truncation errors". Higham 2002, "Accuracy and stability of numerical algorithms", eq. 4.8: the
// error is (2 u + O(count u^2)) sum |x|. The carry goes back into the next term; algorithms that keep a separate sum of the carries
// (Neumaier 1974; Ogita, Rump, Oishi 2005) have (count u)^2, and that sum stalls in its turn: 1600 u after 10^6 terms (seen in the test).
// `precise`: by the rules of real numbers every carry is 0, and a compiler free to use them removes it.
// Error of sum_result: relative 8 u for 10^6 terms of one sign (kernel test CompensatedSum). A sum that overflows is not finite, though
// it may be NaN instead of infinite.
void sum_add(inout Sum3 s, vec3 x) {
    precise vec3 term = x + s.carry;
    precise vec3 total = s.total + term;
    precise vec3 carry = term - (total - s.total);
    s.total = total;
    s.carry = carry;
}

vec3 sum_result(Sum3 s) {
    precise vec3 result = s.total + s.carry;
    return result;
}

#endif
