// Inputs, oracles and domains of the pairs.
#include "measure/numerics/pairs.h"

#include "measure/numerics/rows.h"
#include "measure/numerics/shapes.h"

#include <numbers>

namespace lightbench::kernels {

namespace {

// Judged where the stable form's bound says more than a thousandth.
std::function<bool(std::span<const float>, double)> sure_by(const Bound& bound) {
    return [=](std::span<const float> in, double expected) {
        const double allowed = bound.allowed(in, expected);
        return allowed <= 1e-3 * std::abs(expected) || allowed <= 1.5e-38;
    };
}

bool always(std::span<const float>, double) {
    return true;
}

// The same function, oracle and domain as the row of the stable form.
Pair of_row(const char* name, const char* function, const char* stable, const char* naive, const char* kernel) {
    const Row row = row_of(function);
    const Claim& claim = row.claims.front();
    return {name,
            fmt::format("{}, {}", function, stable),
            naive,
            row.domain,
            kernel,
            {},
            row.inputs,
            claim.oracle.in_double,
            sure_by(claim.allowed)};
}

// Distances that the law is stated for, and 0, where the largest factor is right.
Pair inverse_square_pair() {
    const auto inputs = [](std::size_t count, unsigned seed) {
        return generate(count, 1, seed, [](Random& random, std::span<float> in) {
            in[0] = random() % 64 ? static_cast<float>(log_uniform(random, 1e-15, 1e15)) : 0;
        });
    };
    const auto law = [](std::span<const float> in) {
        const double d = std::max(static_cast<double>(in[0]), 1e-15);
        return 1 / (4 * std::numbers::pi * d * d);
    };
    return {"inverse square",
            "attenuation_inverse_square, held below 1e-15",
            "1/(4 pi d d)",
            "d in [1e-15, 1e15], 0",
            "inverse_square",
            {},
            inputs,
            law,
            always};
}

Pair linear_pair() {
    const auto inputs = [](std::size_t count, unsigned seed) {
        return generate(count, 2, seed, [](Random& random, std::span<float> in) {
            for (float& x : in) x = random() % 8 ? static_cast<float>(log_uniform(random, 1e-18, 1e15)) : 0;
        });
    };
    const auto law = [](std::span<const float> in) { return 1 / std::max(static_cast<double>(in[0]) + static_cast<double>(in[1]), 1e-18); };
    return {"linear", "attenuation_linear, held below 1e-18", "1/(c1 + c2 d)", "d and d0 in [1e-18, 1e15], 0", "linear", {}, inputs, law,
            always};
}

// Cells at their threshold to a few roundings, cells of any contrast, black ones; and intensities whose sum is no float any more.
Pair contrast_pair() {
    const auto inputs = [](std::size_t count, unsigned seed) {
        return generate(count, 3, seed, [](Random& random, std::span<float> in) {
            constexpr float kThresholds[] = {0.25f, 0.2f, 0.4f};
            in[2] = kThresholds[random() % 3];
            const double c = random() % 2 ? static_cast<double>(in[2]) * (1 + uniform(random, -1e-6, 1e-6)) : uniform(random, 0, 1);
            in[0] = static_cast<float>(log_uniform(random, 1e-37, 1e38));
            in[1] = static_cast<float>(static_cast<double>(in[0]) * (1 - c) / (1 + c));
            if (random() % 16 == 0) in[0] = in[1] = 0;
        });
    };
    const auto contrast = [](std::span<const float> in) {
        const double high = static_cast<double>(in[0]), low = static_cast<double>(in[1]);
        return high + low > 0 ? (high - low) / (high + low) : 0;
    };
    const auto decision = [=](std::span<const float> in) { return contrast(in) > static_cast<double>(in[2]) ? 1.0 : 0.0; };
    const auto distance = [=](std::span<const float> in) { return std::abs(contrast(in) / static_cast<double>(in[2]) - 1); };
    return {"contrast",
            "contrast_exceeds, without a quotient",
            "(Imax - Imin)/(Imax + Imin) > c",
            "intensities in [1e-37, 1e38], 0",
            "contrast",
            {},
            inputs,
            decision,
            always,
            distance};
}

constexpr double kClear = 0.03; // of the distance of a sample from the torus: with less between two samples a root may hide

struct FirstRoot {
    double t = kNoHit;
    bool sure = true;
};

// The distance along the line changes by no more than the way: samples closer than twice kClear miss no crossing that is clear.
FirstRoot first_root(std::span<const float> in) {
    const Line line = line_of(in);
    const double m = static_cast<double>(in[6]), after = static_cast<double>(in[7]), size = length(line.d);
    const auto outside = [&](double t) { return torus_distance(line.at(t), m); };
    const double low = std::max(after, line.nearest() - 1.01 * (1 + m) / size), high = line.nearest() + 1.01 * (1 + m) / size;
    const auto steps = static_cast<std::size_t>(std::ceil(std::max(0.0, high - low) * size / (1.5 * kClear)));
    FirstRoot root;
    double before = outside(low);
    root.sure = std::abs(before) > kClear;
    for (std::size_t i = 1; i <= steps; ++i) {
        const double a = low + (high - low) * static_cast<double>(i - 1) / static_cast<double>(steps),
                     b = low + (high - low) * static_cast<double>(i) / static_cast<double>(steps), there = outside(b);
        if ((there < 0) != (before < 0)) {
            root.t = root_between(a, b, outside);
            const double slope = (outside(root.t + 1e-6 / size) - outside(root.t - 1e-6 / size)) / 2e-6; // cosine of incidence
            root.sure = root.sure && std::abs(slope) > 0.3;
            return root;
        }
        // between two samples of one side the line may touch the other only if both are within the step of it
        if (std::min(std::abs(there), std::abs(before)) < 1.5 * kClear && std::abs(there) + std::abs(before) < 1.6 * kClear)
            root.sure = false;
        before = there;
    }
    return root;
}

Pair torus_pair() {
    const auto inputs = [](std::size_t count, unsigned seed) {
        return generate(count, 8, seed, [](Random& random, std::span<float> in) {
            const Vec3 o = random_at(random, 2, 1e3), aim = random_direction(random);
            put(in, 0, o);
            put(in, 3, unit(1.2 * std::cbrt(uniform(random, 0, 1)) * aim - o));
            in[6] = static_cast<float>(uniform(random, 0.1, 0.9));
            in[7] = 0;
        });
    };
    return {"torus",
            "ray_torus, Newton on the distance",
            "quartic by Ferrari",
            "o from 2 to 1e3 away, m in [0.1, 0.9], no tangents",
            "torus",
            {},
            inputs,
            [](std::span<const float> in) { return first_root(in).t; },
            [](std::span<const float> in, double) { return first_root(in).sure; }};
}

} // namespace

std::vector<Pair> all_pairs() {
    Pair phong = of_row("Phong power", "phong_specular", "from |R - V|", "pow(max(R.V, 0), n)", "phong");
    phong.no_float64 = "GLSL has no power of doubles";
    return {of_row("sphere", "ray_sphere", "Haines and others 2019", "b^2 - 4ac", "sphere"),
            torus_pair(),
            of_row("Fresnel", "fresnel", "rational", "sines and tangents", "fresnel"),
            phong,
            inverse_square_pair(),
            linear_pair(),
            contrast_pair()};
}

} // namespace lightbench::kernels
