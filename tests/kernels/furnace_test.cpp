// CT-9: a surface that reflects all light of each facet gives back no more than it gets, and as much as the formulas of SPEC S6 say.
#include "kernel_test.h"
#include "measure/numerics/facets.h"

namespace lightbench::kernels {

namespace {

constexpr int kTheta = 512, kPhi = 1024;

// The factor of D for which the integral of D (N.H) is pi/4 (SPEC S6), by the midpoint rule.
double normalisation(Facets d, double m) {
    if (d == Facets::beckmann) return 1 / (4 * m * m);
    double sum = 0;
    constexpr int kSteps = 100'000;
    const double step = std::numbers::pi / 2 / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const double alpha = (i + 0.5) * step;
        sum += std::exp(-alpha * alpha / (m * m)) * std::sin(2 * alpha) * step;
    }
    return 1 / (4 * sum);
}

double angle_of(int i) {
    return (i + 0.5) * (std::numbers::pi / 2) / kTheta;
}

// Light from every direction of the hemisphere, seen from the angle theta.
Inputs furnace(Facets d, double theta, double m, float ior) {
    Inputs in{14, {}};
    in.values.reserve(std::size_t(14) * kTheta * kPhi);
    const float lobe = static_cast<float>(normalisation(d, m)), slope = static_cast<float>(m);
    const float sine = static_cast<float>(std::sin(theta)), cosine = static_cast<float>(std::cos(theta));
    for (int i = 0; i < kTheta; ++i)
        for (int k = 0; k < kPhi; ++k) {
            const double polar = angle_of(i), phi = (k + 0.5) * 2 * std::numbers::pi / kPhi;
            const float l[] = {static_cast<float>(std::sin(polar) * std::cos(phi)), static_cast<float>(std::sin(polar) * std::sin(phi)),
                               static_cast<float>(std::cos(polar))};
            in.values.insert(in.values.end(), {0, 0, 1, l[0], l[1], l[2], sine, 0, cosine, slope, lobe, ior, ior, ior});
        }
    return in;
}

// Directional albedo: the integral of f cos(theta) over the hemisphere; the kernel's factor is pi times the integrand.
template <class Factor> double albedo(Factor factor) {
    double sum = 0;
    for (int i = 0; i < kTheta; ++i) {
        double ring = 0;
        for (int k = 0; k < kPhi; ++k) ring += factor(std::size_t(i) * kPhi + std::size_t(k));
        sum += ring * std::sin(angle_of(i));
    }
    return sum / std::numbers::pi * (2 * std::numbers::pi / kPhi) * (std::numbers::pi / 2 / kTheta);
}

} // namespace

TEST_F(Kernel, WhiteFurnace) {
    double most = 0, off = 0;
    for (Facets d : {Facets::gaussian, Facets::beckmann})
        for (double m : {0.1, 0.3, 1.0})
            for (double degrees : {0.0, 45.0, 75.0, 88.0}) {
                const Inputs in = furnace(d, degrees * std::numbers::pi / 180, m, 1e6f);
                const KernelRun run = run_kernel(device, kernel_of(d), in, 3);
                const double got = albedo([&](std::size_t i) { return static_cast<double>(run.result(i)[0]); });
                const double expected = albedo([&](std::size_t i) {
                    const std::vector<double> wide(in[i].begin(), in[i].end());
                    return facet_terms(d, std::span<const double>(wide)).value();
                });
                EXPECT_NEAR(got, expected, 1e-4) << kernel_of(d) << " m " << m << " theta " << degrees;
                EXPECT_LE(got, 1 + 1e-3) << kernel_of(d) << " m " << m << " theta " << degrees;
                EXPECT_GE(got, degrees == 0 && m == 0.1 ? 0.98 : 0.3); // nothing is lost where nothing is shadowed
                most = std::max(most, got);
                off = std::max(off, std::abs(got - expected));
            }
    fmt::print("largest albedo {:.6f}, farthest from its quadrature {:.2g}\n", most, off);
}

} // namespace lightbench::kernels
