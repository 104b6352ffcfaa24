// The families of inputs.h.
#include "measure/numerics/inputs.h"

#include "gpu/check.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace lightbench::kernels {

Inputs operator*(const Inputs& a, const Inputs& b) {
    Inputs product{a.arity + b.arity, {}};
    product.values.reserve(a.count() * b.count() * product.arity);
    for (std::size_t i = 0; i < a.count(); ++i)
        for (std::size_t k = 0; k < b.count(); ++k) {
            product.values.insert(product.values.end(), a[i].begin(), a[i].end());
            product.values.insert(product.values.end(), b[k].begin(), b[k].end());
        }
    return product;
}

Inputs operator+(Inputs a, const Inputs& b) {
    CHECK(a.arity == b.arity);
    a.values.insert(a.values.end(), b.values.begin(), b.values.end());
    return a;
}

Inputs only(std::initializer_list<float> values) {
    return {1, values};
}

Inputs grid(double low, double high, std::size_t steps) {
    Inputs axis;
    for (std::size_t i = 0; i < steps; ++i)
        axis.values.push_back(static_cast<float>(low + (high - low) * (static_cast<double>(i) / static_cast<double>(steps - 1))));
    return axis;
}

Inputs log_grid(double low, double high, std::size_t steps) {
    Inputs axis;
    for (std::size_t i = 0; i < steps; ++i)
        axis.values.push_back(static_cast<float>(low * std::pow(high / low, static_cast<double>(i) / static_cast<double>(steps - 1))));
    return axis;
}

Inputs near(float x, int steps) {
    Inputs axis = only({x});
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    float below = x, above = x;
    for (int i = 0; i < steps; ++i) {
        axis.values.push_back(below = std::nextafter(below, -kInfinity));
        axis.values.push_back(above = std::nextafter(above, kInfinity));
    }
    return axis;
}

Inputs special_values() {
    using Limits = std::numeric_limits<float>;
    Inputs axis;
    for (float x : {0.0f, Limits::denorm_min(), Limits::min(), 1e-20f, 0.5f, 1.0f - Limits::epsilon() / 2, 1.0f, 1.0f + Limits::epsilon(),
                    2.0f, 1e20f, Limits::max(), Limits::infinity()}) {
        axis.values.push_back(x);
        axis.values.push_back(-x);
    }
    axis.values.push_back(Limits::quiet_NaN());
    return axis;
}

// Not std::uniform_real_distribution, whose numbers differ between standard libraries.
double uniform(Random& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

double log_uniform(Random& random, double low, double high) {
    return low * std::exp(uniform(random, 0, std::log(high / low)));
}

// Archimedes: heights are uniform on the sphere.
void unit_vector(Random& random, std::span<double, 3> v) {
    const double z = uniform(random, -1, 1), phi = uniform(random, 0, 2 * std::numbers::pi), r = std::sqrt((1 - z) * (1 + z));
    v[0] = r * std::cos(phi);
    v[1] = r * std::sin(phi);
    v[2] = z;
}

Inputs generate(std::size_t count, std::size_t arity, unsigned seed, const std::function<void(Random&, std::span<float>)>& fill) {
    Inputs inputs{arity, std::vector<float>(count * arity)};
    Random random(seed);
    for (std::size_t i = 0; i < count; ++i) fill(random, {inputs.values.data() + i * arity, arity});
    return inputs;
}

Inputs random_bits(std::size_t count, std::size_t arity, unsigned seed) {
    return generate(count, arity, seed, [](Random& random, std::span<float> tuple) {
        for (float& x : tuple) x = std::bit_cast<float>(static_cast<std::uint32_t>(random() >> 32));
    });
}

} // namespace lightbench::kernels
