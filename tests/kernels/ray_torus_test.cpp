// Rays and tori against samples of the distance in double: TO-1, TO-2, TO-3, TO-4.
#include "kernel_test.h"
#include "measure/numerics/shapes.h"

#include <algorithm>
#include <numbers>

namespace lightbench::kernels {

namespace {

const Inputs kMinor = only({0.3f, 1e-4f, 0.05f, 0.9f, 1, 1.5f, 30});

Inputs torus_rays(std::size_t count, unsigned seed) {
    return generate(count, 6, seed, [](Random& random, std::span<float> in) { fill_ray(random, in, 1.5); });
}

Inputs torus_point(const Inputs& x, const Inputs& y, const Inputs& z) {
    return x * y * z;
}

// The same rays, each after the t that it had; without those that have missed.
Inputs after_hits(const KernelRun& run) {
    Inputs again{8, {}};
    for (std::size_t i = 0; i < run.inputs.count(); ++i)
        if (static_cast<double>(run.result(i)[0]) != kNoHit) {
            again.values.insert(again.values.end(), run.inputs[i].begin(), run.inputs[i].begin() + 7);
            again.values.push_back(run.result(i)[0]);
        }
    return again;
}

} // namespace

TEST_F(Kernel, RayTorus) {
    expect_rows(device, "ray_torus");
}

// All roots in turn: four at most.
TEST_F(Kernel, RayTorusAfterHits) {
    KernelRun run = run_kernel(device, "ray_torus", torus_rays(kMillion / 64, 3) * kMinor * only({-1e9f}), 1);
    for (int hit = 0; hit < 4; ++hit) {
        const Inputs again = after_hits(run);
        ASSERT_GT(again.count(), 100u);
        run = run_kernel(device, "ray_torus", again, 1);
        expect_claims(run, "ray_torus");
    }
    EXPECT_EQ(after_hits(run).count(), 0u);
}

// TO-2: on the plane through the tube's top circle, in the plane of the ring, through the middle, tangent to the circles; a little aside.
TEST_F(Kernel, RayTorusTangent) {
    Inputs in{8, {}};
    for (float m : {0.3f, 1e-3f, 0.75f, 1.0f, 1.5f}) {
        const Inputs levels = near(m, 4) + near(0, 1) + near(-m, 2) + only({0.5f * m, 1e-7f});
        const Inputs sides = near(1 - m, 3) + near(1 + m, 3) + near(1, 3) + only({0, 1e-7f, 1e-4f, 0.5f});
        const Inputs along =
            torus_point(only({-3, -0.2f, 0}), sides, levels) * torus_point(only({1}), only({0, 1e-7f, 1e-3f}), only({0, -1e-8f, 1e-5f}));
        const Inputs down = torus_point(sides, only({0, 1e-7f, 0.3f}), only({4, 0})) *
                            torus_point(only({0, 1e-9f, 1e-5f}), only({0, 1e-7f}), only({-1, 0.5f}));
        in = in + (along + down) * only({m}) * only({0});
    }
    expect_claims(run_kernel(device, "ray_torus", in, 1), "ray_torus");
}

// TO-2 again: tangent to the surface at any place, in any direction, moved by so little to either side.
TEST_F(Kernel, RayTorusTouched) {
    const Inputs in = generate(kMillion / 8, 8, 5, [](Random& random, std::span<float> values) {
        const double m = log_uniform(random, 1e-3, 2), phi = uniform(random, 0, 7), theta = uniform(random, 0, 7);
        const Vec3 ring = {std::cos(phi), std::sin(phi), 0}, off = std::cos(theta) * ring + Vec3{0, 0, std::sin(theta)};
        const Vec3 any = random_direction(random), p = ring + m * (1 + log_uniform(random, 1e-8, 1e-2) * (any.x < 0 ? -1 : 1)) * off;
        const Vec3 along = any - dot(any, off) * off;
        put(values, 0, p - uniform(random, 0, 3) / length(along) * along);
        put(values, 3, along);
        values[6] = static_cast<float>(m);
        values[7] = 0;
    });
    expect_claims(run_kernel(device, "ray_torus", in, 1), "ray_torus");
}

// Near the axis the ring is a kink of the distance: through the hole, the horn's and the spindle's dimple.
TEST_F(Kernel, RayTorusNearTheAxis) {
    const Inputs in = generate(kMillion / 8, 8, 6, [](Random& random, std::span<float> values) {
        const Vec3 target = Vec3{0, 0, uniform(random, -1, 1)} + random_at(random, 1e-9, 1e-1);
        put(values, 0, random_at(random, 1e-2, 10));
        put(values, 3, target - vec_of(values, 0));
        values[6] = static_cast<float>(uniform(random, 0, 1) < 0.3 ? 1 : uniform(random, 0.9, 1.3));
        values[7] = 0;
    });
    expect_claims(run_kernel(device, "ray_torus", in, 1), "ray_torus");
}

// TO-3: no minor radius, and one beside which the ring is a point; nothing but a ray hits.
TEST_F(Kernel, RayTorusOfAnything) {
    const auto sane = [](std::span<const float>, std::span<const float> out) {
        return out[0] > 0 && static_cast<double>(out[0]) <= kNoHit ? 0 : 1;
    };
    const Inputs minor = only({0, 1e-20f, 0.5f, 1e4f});
    expect_within(run_kernel(device, "ray_torus", random_bits(kMillion / 4, 6, 1) * minor * only({0})), constant(0), Bound::exact(), sane);
    expect_within(run_kernel(device, "ray_torus", torus_rays(kMillion / 16, 2) * minor * only({0})), constant(0), Bound::exact(), sane);
    const Inputs bad = only({kNaN, std::numeric_limits<float>::infinity()}), any = only({0, 1, -1e30f}) + bad;
    const Inputs ray = torus_point(only({0}), only({0.5f}), only({1})), none = torus_point(only({0}), only({0.0f, -0.0f}), only({0}));
    const Inputs in = ray * torus_point(bad, any, any) + ray * torus_point(any, any, bad) + torus_point(bad, any, any) * ray +
                      torus_point(any, bad, any) * ray + ray * none;
    expect_within(run_kernel(device, "ray_torus", in * minor * only({0})), constant(kNoHit), Bound::exact());
}

// TO-3: beside a large minor radius the torus is a sphere.
TEST_F(Kernel, RayTorusLikeASphere) {
    const Inputs in = generate(kMillion / 16, 8, 8, [](Random& random, std::span<float> values) {
        fill_ray(random, values, 0.8);
        for (std::size_t i = 0; i < 6; ++i) values[i] *= 1e4f;
        values[6] = 1e4f;
        values[7] = 0;
    });
    expect_claims(run_kernel(device, "ray_torus", in, 1), "ray_torus");
}

TEST_F(Kernel, TorusPoint) {
    expect_rows(device, "torus_point");
}

// TO-4: from where a ray has hit, lifted off, away from the surface: never the place itself, but whatever else the torus has in the way.
TEST_F(Kernel, RayTorusLeaves) {
    const Inputs in = generate(kMillion / 4, 12, 9, [](Random& random, std::span<float> values) {
        fill_ray(random, values, 1.2);
        const double m = uniform(random, 0, 1) < 0.5 ? 0.3 : log_uniform(random, 1e-3, 2);
        values[6] = static_cast<float>(m);
        put(values, 7, random_direction(random));
        values[10] = static_cast<float>(5 * kU * (1 + m));
        values[11] = static_cast<float>(1 - std::pow(uniform(random, 0, 1), 8)); // half of all nearly tangent
    });
    const KernelRun run = run_kernel(device, "torus_respawn", in, 8);
    const Bound bound =
        Bound::function([](std::span<const float> values, double) { return 4 * kU * (1 + static_cast<double>(values[6])); });
    expect_within(run, constant(0), bound, [](std::span<const float> values, std::span<const float> out) {
        const double m = static_cast<double>(values[6]);
        if (static_cast<double>(out[0]) == kNoHit) return 0.0;
        return off_torus({vec_of(out, 1), vec_of(out, 4)}, m, 0, 1, static_cast<double>(out[7])); // 1: outside beyond doubt
    });
}

} // namespace lightbench::kernels
