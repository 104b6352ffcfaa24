// Inputs of kernels that explain themselves: axes and products of axes, random families, special values.
// Out: Inputs, a list of argument tuples. `a * b` is every a with every b; `a + b` is both lists.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <random>
#include <span>
#include <vector>

namespace lightbench::kernels {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kFloatMax = std::numeric_limits<float>::max();

struct Inputs {
    std::size_t arity = 1;     // floats a tuple
    std::vector<float> values; // tuple after tuple
    std::size_t count() const { return values.size() / arity; }
    std::span<const float> operator[](std::size_t i) const { return {values.data() + i * arity, arity}; }
};

Inputs operator*(const Inputs& a, const Inputs& b);
Inputs operator+(Inputs a, const Inputs& b);

// Axes: tuples of one float.
Inputs only(std::initializer_list<float> values);
Inputs grid(double low, double high, std::size_t steps);     // ends included
Inputs log_grid(double low, double high, std::size_t steps); // ends included
Inputs near(float x, int steps);                             // x and `steps` neighbours on each side
Inputs special_values();                                     // zeros, denormal and normal limits, about 1, infinities, NaN

// Random families; the same seed gives the same numbers everywhere.
using Random = std::mt19937_64;
double uniform(Random& random, double low, double high);
double log_uniform(Random& random, double low, double high);
void unit_vector(Random& random, std::span<double, 3> v);                // uniform on the sphere
Inputs random_bits(std::size_t count, std::size_t arity, unsigned seed); // anything that a float can hold
Inputs generate(std::size_t count, std::size_t arity, unsigned seed, const std::function<void(Random&, std::span<float>)>& fill);

} // namespace lightbench::kernels
