// Cook-Torrance's factors against SPEC S6 in double and 60 digits: CT-4 to CT-8.
#include "facets.h"

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

const Facets kBoth[] = {Facets::gaussian, Facets::beckmann};

KernelRun run_facets(gpu::Device& device, Facets d, const Inputs& in) {
    return run_kernel(device, kernel_of(d), in, 3);
}

Inputs facets(std::size_t count, unsigned seed, Facets d) {
    return generate(count, 14, seed, [=](Random& random, std::span<float> in) { fill_facet(random, in, d); });
}

// CT-4: cosines from grazing to normal incidence, exact in float.
Inputs grazing() {
    Inputs all{14, {}};
    const float cosines[] = {0, 1e-38f, 1e-30f, 1e-20f, 1e-10f, 1e-7f, 1e-5f, 1e-3f, 0.1f, 0.5f, 0.9f, 1};
    for (float nl : cosines)
        for (float nv : cosines)
            for (double azimuth : {0.0, 0.5, 2.0, 3.0, 3.1415, std::numbers::pi})
                for (float m : {1e-3f, 0.1f, 0.4f, 1.0f, 1000.0f})
                    for (float ior : {1.0f, 1.0003f, 1.5f, 20.0f, 1e6f}) {
                        const auto tuple = exact_geometry(nl, nv, azimuth, m, 0.25f / (m * m), ior);
                        all.values.insert(all.values.end(), tuple.begin(), tuple.end());
                    }
    return all;
}

void expect_finite(const KernelRun& run) {
    const Measure off = [](std::span<const float>, std::span<const float> out) {
        return std::isfinite(out[0] + out[1] + out[2]) && out[0] >= 0 && out[1] >= 0 && out[2] >= 0 ? 0.0 : 1.0;
    };
    expect_within(run, constant(0), Bound::exact(), off);
}

} // namespace

TEST_F(Kernel, CookTorranceGaussian) {
    for (unsigned seed : seeds()) {
        const Inputs in = facets(kMillion, seed, Facets::gaussian);
        expect_within(run_facets(device, Facets::gaussian, in), facet_oracle(Facets::gaussian), facet_bound(Facets::gaussian));
    }
}

TEST_F(Kernel, CookTorranceBeckmann) {
    for (unsigned seed : seeds()) {
        const Inputs in = facets(kMillion, seed, Facets::beckmann);
        expect_within(run_facets(device, Facets::beckmann, in), facet_oracle(Facets::beckmann), facet_bound(Facets::beckmann));
    }
}

TEST_F(Kernel, CookTorranceGrazing) {
    for (Facets d : kBoth) {
        const KernelRun run = run_facets(device, d, grazing());
        expect_within(run, facet_oracle(d), facet_bound(d));
        expect_finite(run);
    }
}

// 60 digits for 10^5 inputs, as the oracle in double is only sampled by them otherwise.
TEST_F(Kernel, CookTorranceIn60Digits) {
    if (seeds().size() == 1) GTEST_SKIP() << "minutes: LIGHTBENCH_LONG_TESTS=1";
    for (Facets d : kBoth) {
        const Oracle slow{facet_oracle(d).in_60_digits, facet_oracle(d).in_60_digits};
        expect_within(run_facets(device, d, facets(50'000, 11, d)), slow, facet_bound(d));
    }
}

// Any unit vectors at all, L = -V and its neighbours, N among them; slopes and factors of both ends.
TEST_F(Kernel, CookTorranceIsFinite) {
    const Inputs any = generate(kMillion / 4, 14, 5, [](Random& random, std::span<float> in) {
        fill_facet(random, in, Facets::gaussian);
        double d[3];
        for (std::size_t at : {0, 3, 6}) {
            unit_vector(random, d);
            for (std::size_t i = 0; i < 3; ++i) in[at + i] = static_cast<float>(d[i]);
        }
        const auto opposite = random() % 4;
        const double away = log_uniform(random, 1e-9, 1);
        if (opposite == 0)
            for (std::size_t i = 0; i < 3; ++i)
                in[6 + i] = -in[3 + i] + static_cast<float>(away * d[i]) * (random() % 2 == 0 ? 1.0f : 0.0f);
        in[11] = static_cast<float>(log_uniform(random, 0.1, 1e9));
    });
    for (Facets d : kBoth) expect_finite(run_facets(device, d, any));
}

// CT-7, LI-3: nothing where there is no half vector, and nothing through a surface from behind.
TEST_F(Kernel, CookTorranceIsDarkFromBehind) {
    const auto zero = [&](Facets d, const Inputs& in) { expect_within(run_facets(device, d, in), constant(0), Bound::exact()); };
    const Inputs tail = only({0.3f}) * only({2.5f}) * only({1.5f}) * only({1.5f}) * only({1.5f});
    const auto vec = [](float x, float y, float z) { return only({x}) * only({y}) * only({z}); };
    const Inputs up = vec(0, 0, 1), down = vec(0, 0, -1), side = vec(1, 0, 0), back = vec(-1, 0, 0), slant = vec(0.6f, 0, 0.8f);
    for (Facets d : kBoth)
        zero(d, up *
                    (side * back + side * side + down * down + down * slant + slant * down + slant * side + side * slant +
                     slant * vec(-0.6f, 0, -0.8f)) *
                    tail);
}

// CT-8. Three roundings on either side differ.
TEST_F(Kernel, CookTorranceIsReciprocal) {
    const KernelRun run = run_kernel(device, "cook_torrance_swapped", facets(100'000, 3, Facets::gaussian), 4);
    for (std::size_t first : {0, 2}) {
        const Measure off = [=](std::span<const float>, std::span<const float> out) {
            const double a = static_cast<double>(out[first]), b = static_cast<double>(out[first + 1]);
            return a == b ? 0 : std::abs(a - b) < 1e-36 ? 0 : std::abs(a - b) / std::max(a, b);
        };
        expect_within(run, constant(0), Bound::absolute(6 * kU), off);
    }
}

// Each channel has its own index, and only that.
TEST_F(Kernel, CookTorranceChannels) {
    Inputs in = facets(1000, 4, Facets::gaussian), turned = in;
    for (std::size_t i = 0; i < in.values.size(); i += 14) {
        in.values[i + 13] = 3.0f;
        for (std::size_t k : {0, 1, 2}) turned.values[i + 11 + k] = in.values[i + 11 + (k + 1) % 3];
    }
    for (Facets d : kBoth) {
        const KernelRun run = run_facets(device, d, in), other = run_facets(device, d, turned);
        for (std::size_t i = 0; i < in.count(); ++i)
            for (std::size_t k : {0, 1, 2}) ASSERT_EQ(other.result(i)[k], run.result(i)[(k + 1) % 3]);
    }
}

TEST_F(Kernel, CookTorranceKeepsNaN) {
    const auto tuple = exact_geometry(0.8f, 0.6f, 1, 0.3f, 2.5f, 1.5f);
    Inputs in{14, {}};
    for (std::size_t k = 0; k < 12; ++k) {
        in.values.insert(in.values.end(), tuple.begin(), tuple.end());
        in.values[in.values.size() - 14 + k] = kNaN;
    }
    for (Facets d : kBoth) expect_within(run_facets(device, d, in), constant(static_cast<double>(kNaN)), Bound::exact());
}

} // namespace lightbench::kernels
