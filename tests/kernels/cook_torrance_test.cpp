// Cook-Torrance's factors against SPEC S6 in double and 60 digits: CT-4 to CT-8.
#include "kernel_test.h"
#include "measure/numerics/facets.h"

namespace lightbench::kernels {

namespace {

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
    expect_rows(device, "cook_torrance_gaussian");
}

TEST_F(Kernel, CookTorranceBeckmann) {
    expect_rows(device, "cook_torrance_beckmann");
}

TEST_F(Kernel, CookTorranceGrazing) {
    for (Facets d : kBoth) {
        const KernelRun run = run_facets(device, d, grazing());
        expect_claims(run, kernel_of(d));
        expect_finite(run);
    }
}

// 60 digits for 10^5 inputs, as the oracle in double is only sampled by them otherwise.
TEST_F(Kernel, CookTorranceIn60Digits) {
    if (seeds().size() == 1) GTEST_SKIP() << "minutes: LIGHTBENCH_LONG_TESTS=1";
    for (Facets d : kBoth) {
        const Claim claim = row_of(kernel_of(d)).claims[0];
        const Oracle slow{claim.oracle.in_60_digits, claim.oracle.in_60_digits};
        expect_within(run_facets(device, d, facets(50'000, 11, d)), slow, claim.allowed);
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
