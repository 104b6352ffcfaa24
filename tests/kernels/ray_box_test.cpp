// Rays against the cube and against bounding boxes, whose bounds are about what is in them: BX-1, BX-2, BX-3, PR-1.
#include "kernel_test.h"
#include "measure/numerics/rays.h"

namespace lightbench::kernels {

namespace {

// Triangles flat in axis planes, thin, large, small; rays at their vertices and edges, along axes and in their planes.
Inputs bounded_triangles(unsigned seed) {
    return generate(kMillion, 15, seed, [](Random& random, std::span<float> in) {
        const double size = log_uniform(random, 1e-4, 10);
        const Vec3 a = random_in_cube(random, 10);
        put(in, 6, a);
        put(in, 9, a + random_in_cube(random, size));
        put(in, 12, a + random_in_cube(random, random() % 2 ? size : 1e-3 * size));
        const std::size_t flat = random() % 6;
        if (flat < 3) in[9 + flat] = in[12 + flat] = in[6 + flat];
        const Vec3 v[3] = {vec_of(in, 6), vec_of(in, 9), vec_of(in, 12)};
        const double b = random() % 2 ? 0 : uniform(random, 0, 1), c = random() % 2 ? 0 : uniform(random, 0, 1 - b);
        const Vec3 aim = v[0] + b * (v[1] - v[0]) + c * (v[2] - v[0]);
        put(in, 0, aim + log_uniform(random, 1e-3, 20) * random_direction(random));
        const std::size_t axis = random() % 12;
        if (axis < 3) // along an axis, or in an axis plane
            for (std::size_t k = 0; k < 3; ++k) in[k] = k == axis ? in[k] : in[6 + k];
        else if (axis < 6)
            in[axis - 3] = in[6 + axis - 3];
        put(in, 3, unit((axis < 6 ? v[0] : aim) - vec_of(in, 0)));
    });
}

Inputs bounded_spheres(unsigned seed) {
    return generate(kMillion, 10, seed, [](Random& random, std::span<float> in) {
        const double r = log_uniform(random, 1e-5, 10);
        const Vec3 c = random_in_cube(random, 10), o = random_in_cube(random, 30);
        const Vec3 side = unit(cross(o - c, random_direction(random)));
        put(in, 0, o);
        put(in, 3, unit(c + ((random() % 2 ? uniform(random, 0, 1) : 1) * r) * side - o)); // half of them tangent
        put(in, 6, c);
        in[9] = static_cast<float>(r);
    });
}

// What was hit is in a box that was entered before.
double bounded(std::span<const float>, std::span<const float> out) {
    return out[0] < kFloatMax && !(out[1] <= out[0]) ? 1 : 0;
}

// The same where the products of the edge functions are at most four times their sum: they are below longest^2, and it is area cosine.
double bounded_if_not_thin(std::span<const float> in, std::span<const float> out) {
    const Vec3 v0 = vec_of(in, 6), u = vec_of(in, 9) - v0, v = vec_of(in, 12) - v0, normal = cross(u, v);
    const double longest = std::max({length(u), length(v), length(u - v)});
    const bool thin = longest * longest > 4 * std::abs(dot(normal, vec_of(in, 3)));
    return out[0] < kFloatMax && (thin ? !(out[2] < kFloatMax) : !(out[1] <= out[0])) ? 1 : 0;
}

double share_hit(const KernelRun& run) {
    std::size_t hits = 0;
    for (std::size_t i = 0; i < run.inputs.count(); ++i) hits += run.result(i)[0] < kFloatMax;
    return static_cast<double>(hits) / static_cast<double>(run.inputs.count());
}

} // namespace

TEST_F(Kernel, RayCube) {
    expect_rows(device, "ray_cube");
}

// BX-2: from inside every ray leaves, through corners too; PR-1: rays that are not finite miss.
TEST_F(Kernel, RayCubeSpecialRays) {
    const Inputs inside = only({0, -0.0f, 1, -1, 0.5f}), way = only({0, 1, -1, 0.5f}), special = special_values();
    const Inputs from = inside * inside * inside * way * way * way * only({-1e-30f});
    expect_within(run_kernel(device, "ray_cube", from, 8), constant(1), Bound::exact(),
                  [](std::span<const float> in, std::span<const float> out) {
                      const bool still = in[3] == 0 && in[4] == 0 && in[5] == 0;
                      return still || out[0] < kFloatMax ? 1 : 0;
                  });
    expect_within(
        run_kernel(device, "ray_cube", special * special * only({0.0f, kNaN}) * special * special * only({1.0f, kNaN}) * only({0}), 8),
        constant(1), Bound::exact(), [](std::span<const float> in, std::span<const float> out) {
            bool number = true;
            for (float x : in) number = number && !std::isnan(x);
            return out[0] > 0 && (number || out[0] == kFloatMax) ? 1 : 0;
        });
}

TEST_F(Kernel, Slab) {
    expect_rows(device, "slab");
}

TEST_F(Kernel, SlabsHoldWhatIsInThem) {
    for (unsigned seed : seeds()) {
        const KernelRun triangles = run_kernel(device, "bounded_triangle", bounded_triangles(seed), 3);
        EXPECT_GT(share_hit(triangles), 0.3);
        expect_within(triangles, constant(0), Bound::exact(), bounded_if_not_thin);
        const KernelRun spheres = run_kernel(device, "bounded_sphere", bounded_spheres(seed), 2);
        EXPECT_GT(share_hit(spheres), 0.5);
        expect_within(spheres, constant(0), Bound::exact(), bounded);
    }
}

TEST_F(Kernel, Traceable) {
    const Inputs special = special_values();
    const Inputs rays = special * special * only({0}) * special * only({0.0f, 1.0f}) * special;
    expect_within(run_kernel(device, "traceable", rays, 1), constant(1), Bound::exact(),
                  [](std::span<const float> in, std::span<const float> out) {
                      bool good = in[3] != 0 || in[4] != 0 || in[5] != 0, small = true;
                      for (float x : in) good = good && std::abs(x) < kFloatMax;
                      for (float x : in.subspan(3)) small = small && std::abs(x) <= 0x1p-126f; // may count as 0
                      return (out[0] == 1) == good || small ? 1 : 0;
                  });
}

} // namespace lightbench::kernels
