// What a kernel should have computed, and how far off it may be. In: argument tuples. Out: expected values, allowed errors.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace lightbench::kernels {

constexpr double kU = 0x1p-24; // unit roundoff of float

using Precise = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

// One formula, written for any number type: every input is judged by it in double; a sample is computed again in 60 digits, and double
// must agree there to a thousandth of the bound.
struct Oracle {
    std::function<double(std::span<const float>)> in_double, in_60_digits;
};

// formula(span of T) -> T, for T double and Precise.
template <class Formula> Oracle oracle(Formula formula) {
    return {[=](std::span<const float> in) {
                const std::vector<double> x(in.begin(), in.end());
                return static_cast<double>(formula(std::span<const double>(x)));
            },
            [=](std::span<const float> in) {
                const std::vector<Precise> x(in.begin(), in.end());
                return static_cast<double>(formula(std::span<const Precise>(x)));
            }};
}

// The same number for every input.
inline Oracle constant(double value) {
    return {[=](std::span<const float>) { return value; }, [=](std::span<const float>) { return value; }};
}

// Allowed |got - expected|; 0: the very number (zeros of either sign are one number).
struct Bound {
    std::function<double(std::span<const float> in, double expected)> allowed;
    static Bound relative(double r) {
        return {[=](std::span<const float>, double expected) { return r * std::abs(expected); }};
    }
    static Bound absolute(double a) {
        return {[=](std::span<const float>, double) { return a; }};
    }
    static Bound exact() { return absolute(0); }
    static Bound ulp(double n); // of the expected value as a float
    static Bound function(std::function<double(std::span<const float>, double)> f) { return {std::move(f)}; }
};

} // namespace lightbench::kernels
