// Cook-Torrance's factors against SPEC S6 in double and 60 digits, and rough facets against the slopes they are drawn from: CT-4 to CT-8.
#include "measure/numerics/lines.h"
#include "measure/numerics/rows.h"

namespace lightbench::kernels {

namespace {

Oracle facet_oracle(Facets d) {
    return oracle([=](auto in) {
        using T = std::remove_cvref_t<decltype(in[0])>;
        const Vec<T> h = sum(vec_at(in, 3), vec_at(in, 6));
        const T nl = dot(vec_at(in, 0), vec_at(in, 3)), nv = dot(vec_at(in, 0), vec_at(in, 6));
        if (nl < 0x1p-126 || nv < 0x1p-126 || dot(h, h) < 1e-12) return T(0);
        return facet_terms(d, in).value();
    });
}

// What 3 u of the products that make it up are of a dot product.
double dot_error(std::span<const double> in, std::size_t a, std::size_t b) {
    double magnitudes = 0, product = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        magnitudes += std::abs(in[a + i] * in[b + i]);
        product += in[a + i] * in[b + i];
    }
    return product > 4 * kU * magnitudes ? 3 * magnitudes / product : 1e30;
}

// As cook_torrance.glsl states it, the errors of N.L and N.V being what they are here.
const double kBase = 13, kSlope = 8;
Bound facet_bound(Facets d) {
    return Bound::function([=](std::span<const float> in, double expected) {
        const std::vector<double> wide(in.begin(), in.end());
        const std::span<const double> x(wide);
        const double dots = std::max(dot_error(x, 0, 3), dot_error(x, 0, 6));
        if (dots > 1e29) return 1e30; // on the terminator either side is right
        const FacetTerms<double> t = facet_terms(d, x);
        const double e = t.exponent, turned = std::sqrt(e) / (1000 * wide[9]);
        const double ends = std::abs(e - 87.3) < 0.1 ? 2e-38 * t.spread * t.open : 0; // exp_negative stops there
        return (kBase + kSlope * e + 2 * turned + (1 + 2 * e) * dots) * kU * expected + ends + 2e-38 * (1 + t.open);
    });
}

Row facet_row(Facets d) {
    return {kernel_of(d),
            "lib/cook_torrance.glsl",
            "lit and seen facets, m in [1e-3, 1], n in [1.01, 30]",
            kernel_of(d),
            3,
            [=](std::size_t count, unsigned seed) {
                return generate(count, 14, seed, [=](Random& random, std::span<float> in) { fill_facet(random, in, d); });
            },
            {{"", "relative (13 + 8e + 2 sqrt(e)/(1000 m) + (1 + 2e) dots) u, D's exponent e", facet_oracle(d), facet_bound(d)}}};
}

void fill_scatter(Random& random, std::span<float> in) {
    put(in, 0, random_direction(random));
    in[3] = static_cast<float>(log_uniform(random, 1e-4, 3));
    in[4] = static_cast<float>(uniform(random, 0, 0.99999));
    in[5] = static_cast<float>(uniform(random, 0, 0.99999));
}

double expected_angle(std::span<const float> in) {
    return std::atan(static_cast<double>(in[3]) * std::sqrt(-std::log1p(-static_cast<double>(in[4]))));
}

// Angle between the facet and n.
double scattered_angle(std::span<const float> in, std::span<const float> out) {
    const Vec3 n = vec_of(in, 0), h = vec_of(out, 0);
    return std::atan(length(cross(n, h)) / dot(n, h));
}

} // namespace

Rows facet_rows() {
    const Measure result_length = [](std::span<const float>, std::span<const float> out) { return length(vec_of(out, 0)); };
    return {facet_row(Facets::gaussian),
            facet_row(Facets::beckmann),
            {"scattered_normal",
             "lib/scatter.glsl",
             "n unit, slope in [1e-4, 3], xi in [0, 1)",
             "scattered_normal",
             3,
             [](std::size_t count, unsigned seed) { return generate(count, 6, seed, fill_scatter); },
             {{"length", "absolute 6 u", constant(1), Bound::absolute(6 * kU), result_length},
              {"angle from n", "absolute 8 u", {expected_angle, expected_angle}, Bound::absolute(8 * kU), scattered_angle}}}};
}

} // namespace lightbench::kernels
