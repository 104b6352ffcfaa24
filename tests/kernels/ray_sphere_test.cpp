// Rays against spheres, near and far, inside and tangent, against roots in double and in 60 digits: SP-1, SP-2, SP-3, PR-1.
#include "kernel_test.h"
#include "measure/numerics/rays.h"

namespace lightbench::kernels {

namespace {

void put_ray(std::span<float> in, const Vec3& o, const Vec3& d, const Vec3& c, double r) {
    put(in, 0, o);
    put(in, 3, d);
    put(in, 6, c);
    in[9] = static_cast<float>(r);
    in[10] = 0;
}

} // namespace

TEST_F(Kernel, RaySphere) {
    expect_rows(device, "ray_sphere");
}

// SP-1: rays at the disc hit, from any distance, where rounding leaves no doubt.
TEST_F(Kernel, RaySphereFarAway) {
    for (double far : {1e2, 1e3, 1e4, 1e5, 1e6}) {
        const Inputs in = generate(kMillion / 8, 11, 3, [=](Random& random, std::span<float> tuple) {
            const Vec3 way = random_direction(random), aim = uniform(random, 0, 0.4) * unit(cross(way, random_direction(random)));
            put_ray(tuple, Vec3{0, 0, 0} - far * way, unit(aim + far * way), {0, 0, 0}, 1);
        });
        expect_within(run_kernel(device, "ray_sphere", in, 10), constant(1), Bound::exact(),
                      [](std::span<const float>, std::span<const float> out) { return out[0] < kFloatMax ? 1 : 0; });
    }
}

// SP-2: a ground of radius 10^3 to 10^9, the camera about 1 above its top; rays straight down, and others.
TEST_F(Kernel, NearSphere) {
    expect_rows(device, "near_sphere");
}

// SP-3: centre, surface, zero directions, directions of NaN and infinity (PR-1).
TEST_F(Kernel, RaySphereSpecialRays) {
    const Inputs special = special_values();
    const Inputs any = special * special * special * only({0.0f, 1.0f, kNaN});
    Inputs in{11, {}};
    for (std::size_t i = 0; i < any.count(); ++i) {
        const std::span<const float> x = any[i];
        in.values.insert(in.values.end(), {x[3], 0, 0, x[0], x[1], x[2], 0, 0, 0, 1, 0});
        in.values.insert(in.values.end(), {x[0], x[1], x[2], 1, 0, 0, 0, 0, 0, 1, 0});
    }
    const auto sane = [](std::span<const float> x, std::span<const float> out) {
        bool finite = true;
        for (float v : x) finite = finite && std::isfinite(v);
        return out[0] > 0 && (finite ? out[0] <= kFloatMax : out[0] == kFloatMax) ? 1.0 : 0.0;
    };
    expect_within(run_kernel(device, "ray_sphere", in, 10), constant(1), Bound::exact(), sane);
    const Inputs out_of = generate(kMillion / 16, 11, 1, [](Random& random, std::span<float> tuple) {
        put_ray(tuple, {0, 0, 0}, random_direction(random), {0, 0, 0}, 2);
    });
    expect_within(run_kernel(device, "ray_sphere", out_of, 10), constant(2), Bound::relative(8 * kU));
}

// The unit ball for directions of any length: t scales with their inverse.
TEST_F(Kernel, RayBall) {
    expect_rows(device, "ray_ball");
}

} // namespace lightbench::kernels
