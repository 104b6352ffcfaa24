// Rays and truncated cones against sections of a convex function in double: CY-1, CY-2, CO-1, CO-2, CO-3.
#include "kernel_test.h"
#include "measure/numerics/shapes.h"

#include <algorithm>

namespace lightbench::kernels {

namespace {

const Inputs kRadii = cone_radii();
const Inputs kCapped = only({0, 1});

Inputs rays(std::size_t count, unsigned seed) {
    return generate(count, 6, seed, [](Random& random, std::span<float> in) { fill_ray(random, in, 1.5); });
}

// From every start to every target, and a little aside.
Inputs aimed(const Inputs& starts, const Inputs& targets, unsigned seed) {
    Inputs in{6, {}};
    Random random(seed);
    for (std::size_t i = 0; i < starts.count(); ++i)
        for (std::size_t k = 0; k < targets.count(); ++k)
            for (double aside : {0.0, 1e-8, 1e-7, 1e-6, 1e-4}) {
                const Vec3 o = vec_of(starts[i], 0), target = vec_of(targets[k], 0) + aside * random_direction(random);
                std::array<float, 6> ray{};
                put(ray, 0, o);
                put(ray, 3, target - o);
                in.values.insert(in.values.end(), ray.begin(), ray.end());
            }
    return in;
}

Inputs vec(const Inputs& x, const Inputs& y, const Inputs& z) {
    return x * y * z;
}

} // namespace

TEST_F(Kernel, RayCone) {
    expect_rows(device, "ray_cone");
}

// The second hit: after is the t of the first.
TEST_F(Kernel, RayConeAfterTheFirstHit) {
    const KernelRun first = run_kernel(device, "ray_cone", rays(kMillion / 64, 7) * kRadii * kCapped * only({0}), 2);
    Inputs again = first.inputs;
    for (std::size_t i = 0; i < again.count(); ++i) again.values[i * 10 + 9] = first.result(i)[0];
    std::erase_if(again.values, [&, at = std::size_t{0}](float) mutable { return first.result(at++ / 10)[0] == 3.4028235e38f; });
    ASSERT_GT(again.count(), 1000u);
    expect_claims(run_kernel(device, "ray_cone", again, 2), "ray_cone");
}

// CY-1: along the axis, and so little across it that squares vanish; about the rims, in the planes of the caps.
TEST_F(Kernel, RayConeAlongTheAxis) {
    const Inputs across = only({0, 1e-30f, 1e-20f, -1e-14f, 1e-10f, -1e-8f, 1e-7f, 1e-6f, 1e-4f});
    const Inputs places = vec(near(1, 3) + only({0, 0.5f, -0.999f, 1e-8f, 1.5f}), only({0, 1e-7f}), only({-5, -1, 0, 0.5f, 1, 3000}));
    expect_claims(
        run_kernel(device, "ray_cone", places * vec(across, only({0, 1e-7f}), only({1, -1, 1e-6f})) * kRadii * kCapped * only({0}), 2),
        "ray_cone");
    const Inputs flat = vec(near(1, 2) + only({-3, 0, 0.5f}), only({-2, 0, 1}), near(1, 2) + near(-1, 2)) *
                        vec(only({1, -1, 0.5f}), only({1, 0, 0.3f}), only({0, 1e-30f, -1e-20f, 1e-9f, 1e-7f}));
    expect_claims(run_kernel(device, "ray_cone", flat * kRadii * kCapped * only({0}), 2), "ray_cone");
}

// CO-1, CO-2: through the apex, along generators, through rims, tangent.
TEST_F(Kernel, RayConeAtSpecialPoints) {
    const Inputs starts = vec(only({0, 1, -1, 1.5f, 40}), only({0, 0.5f, -3}), only({-3, -1, 0, 0.4f, 1, 20}));
    const Inputs targets = vec(only({0, 1, -1, 0.6f}), only({0, 0.8f}), only({-1, 1, 0.25f, -1.5f}));
    expect_claims(run_kernel(device, "ray_cone", aimed(starts, targets, 3) * kRadii * kCapped * only({0}), 2), "ray_cone");
}

// CO-2: directions that turn through that of a generator, where the quadratic loses its square.
TEST_F(Kernel, RayConeAlongAGenerator) {
    const Inputs turns = log_grid(1e-10, 1e-2, 17);
    Inputs in{10, {}};
    for (std::size_t r = 0; r < kRadii.count(); ++r)
        for (float place : {-1.2f, -0.9f, -0.5f, -0.1f, 0.0f, 0.5f, 0.8f, 1.0f})
            for (float turn : turns.values)
                for (float x : {turn, -turn, 0.0f}) {
                    const float slope = 0.5f * (kRadii[r][1] - kRadii[r][0]);
                    in.values.insert(in.values.end(), {place, 0.05f, -1.5f, slope + x, 0, 1, kRadii[r][0], kRadii[r][1], 0, 0});
                    in.values.insert(in.values.end(), {place, 0, 0.2f, slope, x, -1, kRadii[r][0], kRadii[r][1], 1, 0});
                }
    expect_claims(run_kernel(device, "ray_cone", in, 2), "ray_cone");
}

// CY-2: from inside a closed cone, to its rims and everywhere else, no ray gets out unseen.
TEST_F(Kernel, RayConeIsClosed) {
    const Inputs in = generate(kMillion, 10, 5, [](Random& random, std::span<float> values) {
        const double r0 = uniform(random, 0, 1), phi = uniform(random, 0, 7), z = uniform(random, -0.9, 0.9);
        const double side = uniform(random, -1, 1) < 0 ? -1 : 1, radius = side < 0 ? r0 : 1;
        const Vec3 o =
            0.9 * uniform(random, 0, 0.5 * (1 + r0) - 0.5 * (1 - r0) * std::abs(z)) * Vec3{std::cos(3 * phi), std::sin(3 * phi), 0};
        const Vec3 rim = {radius * std::cos(phi), radius * std::sin(phi), side};
        const Vec3 target = uniform(random, 0, 1) < 0.8 ? rim : 3.0 * random_direction(random);
        put(values, 0, o + z * Vec3{0, 0, 1});
        put(values, 3, target - vec_of(values, 0));
        values[6] = static_cast<float>(r0);
        values[7] = 1;
        values[8] = 1;
        values[9] = 0;
    });
    const KernelRun run = run_kernel(device, "ray_cone", in, 2);
    expect_within(run, constant(0), Bound::exact(),
                  [](std::span<const float>, std::span<const float> out) { return static_cast<double>(out[0]) == kNoHit ? 1 : 0; });
}

// Whatever is not a ray misses; what is one gives no NaN.
TEST_F(Kernel, RayConeOfAnything) {
    const Inputs shape = only({0.5f}) * only({1}) * only({1}) * only({0});
    const Inputs bad = only({kNaN, std::numeric_limits<float>::infinity()}), any = only({0, 1, -1e30f}) + bad;
    const Inputs ray = vec(only({0}), only({0.5f}), only({1})), none = vec(only({0}), only({0.0f, -0.0f}), only({0}));
    const Inputs in =
        ray * vec(bad, any, any) + ray * vec(any, any, bad) + vec(bad, any, any) * ray + vec(any, bad, any) * ray + ray * none;
    expect_within(run_kernel(device, "ray_cone", in * shape, 2), constant(kNoHit), Bound::exact());
    const auto sane = [](std::span<const float>, std::span<const float> out) {
        return out[0] > 0 && static_cast<double>(out[0]) <= kNoHit ? 0 : 1;
    };
    expect_within(run_kernel(device, "ray_cone", random_bits(kMillion, 6, 1) * shape, 2), constant(0), Bound::exact(), sane);
}

TEST_F(Kernel, ConePoint) {
    expect_rows(device, "cone_point");
}

constexpr float kLean[] = {0, 0.99f, 0.99999f, 1}; // shares of a direction along the normal that are taken off

// Convex: what leaves the surface never meets it again.
TEST_F(Kernel, RayConeLeaves) {
    const Inputs direction = generate(kMillion, 3, 9, [](Random& random, std::span<float> w) { put(w, 0, random_direction(random)); });
    Inputs in{13, {}};
    const Inputs from = rays(direction.count(), 11);
    for (std::size_t i = 0; i < direction.count(); ++i) {
        const std::span<const float> radii = kRadii[i % kRadii.count()];
        in.values.insert(in.values.end(), from[i].begin(), from[i].end());
        in.values.insert(in.values.end(), radii.begin(), radii.end());
        in.values.insert(in.values.end(), direction[i].begin(), direction[i].end());
        in.values.push_back(static_cast<float>(24 * kU)); // kConeClearance
        in.values.push_back(kLean[i % 4]);
    }
    const KernelRun run = run_kernel(device, "cone_respawn", in, 2);
    expect_within(run, constant(kNoHit), Bound::exact(), [](std::span<const float>, std::span<const float> out) {
        return static_cast<double>(out[0]) == kNoHit ? kNoHit : static_cast<double>(out[1]);
    });
}

} // namespace lightbench::kernels
