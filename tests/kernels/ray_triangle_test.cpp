// Rays against triangles: t and barycentrics against determinants in double and 60 digits, closed meshes without leaks: PL-1, PL-2, PL-5, PL-6.
#include "kernel_test.h"
#include "measure/numerics/rays.h"

namespace lightbench::kernels {

namespace {

// Octahedra about a point, seen from inside. Every ray aims at a vertex, at an edge, or anywhere; `away`: where the whole is.
Inputs octahedra(unsigned seed, const Vec3& away, double size) {
    return generate(kMillion, 24, seed, [=](Random& random, std::span<float> in) {
        const Vec3 x = random_direction(random), y = unit(cross(x, random_direction(random))), z = cross(x, y);
        const Vec3 axes[3] = {x, y, z};
        Vec3 v[6];
        for (std::size_t i = 0; i < 6; ++i) {
            put(in, 6 + 3 * i, away + (size * (i % 2 ? -1 : 1) * log_uniform(random, 0.1, 10)) * axes[i / 2]);
            v[i] = vec_of(in, 6 + 3 * i);
        }
        const std::size_t a = random() % 6, b = (a + 2 + random() % 4 - a % 2) % 6; // another axis: an edge of the octahedron
        put(in, 0, away + uniform(random, 0, 0.5) * (v[random() % 6] - away));
        const Vec3 o = vec_of(in, 0), edge = v[a] + uniform(random, 0, 1) * (v[b] - v[a]);
        const auto aim = random() % 3;
        put(in, 3, unit(aim == 0 ? v[a] - o : aim == 1 ? edge - o : random_direction(random)));
    });
}

// Coordinates of few bits: rays meet vertices and edges exactly, and triangles are seen edge on.
Inputs lattice_octahedra(unsigned seed) {
    return generate(kMillion, 24, seed, [](Random& random, std::span<float> in) {
        for (std::size_t i = 0; i < 6; ++i) {
            float* v = &in[6 + 3 * i];
            v[0] = v[1] = v[2] = 0;
            v[i / 2] = static_cast<float>(static_cast<int>(1 + random() % 8) * (i % 2 ? -1 : 1));
        }
        const std::size_t a = random() % 3, b = random() % 3;
        const bool whole = random() % 2;
        for (std::size_t k = 0; k < 3; ++k) {
            in[k] = 0;
            const float va = in[6 + 6 * a + 3 * (random() % 2) + k], vb = in[6 + 6 * b + 3 * (random() % 2) + k];
            in[3 + k] = whole ? va : va + vb;
        }
        if (in[3] == 0 && in[4] == 0 && in[5] == 0) in[3] = 1;
    });
}

Measure faces_hit() {
    return [](std::span<const float>, std::span<const float> out) { return out[0] >= 1 ? 1.0 : 0.0; };
}

} // namespace

TEST_F(Kernel, RayTriangle) {
    expect_rows(device, "ray_triangle");
}

// PL-1: no ray leaves a closed mesh.
TEST_F(Kernel, RayTriangleIsWatertight) {
    for (unsigned seed : seeds()) {
        expect_within(run_kernel(device, "ray_octahedron", octahedra(seed, {0, 0, 0}, 1), 2), constant(1), Bound::exact(), faces_hit());
        expect_within(run_kernel(device, "ray_octahedron", octahedra(seed, {148376, 1234, -223423}, 100), 2), constant(1), Bound::exact(),
                      faces_hit());
        expect_within(run_kernel(device, "ray_octahedron", lattice_octahedra(seed), 2), constant(1), Bound::exact(), faces_hit());
    }
}

// The test of the test: a triangle test that decides for every triangle by itself leaks.
TEST_F(Kernel, LeaksAreReported) {
    const KernelRun run = run_kernel(device, "leaky_octahedron", octahedra(1, {148376, 1234, -223423}, 100), 2);
    EXPECT_FALSE(judge(run, constant(1), Bound::exact(), faces_hit()).holds);
}

// PL-2, PL-6, PR-1: equal vertices, in the plane, behind, at the origin, not finite.
TEST_F(Kernel, RayTriangleMisses) {
    Inputs in{16, {}};
    const auto add = [&](std::initializer_list<float> tuple) { in.values.insert(in.values.end(), tuple); };
    add({0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, -1, -1, 1, 0});              // two vertices are one
    add({0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0});                // all are one, hit in the middle
    add({0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 2, 0, -1, 3, 0});               // seen edge on, the ray in its plane
    add({0, 0, 0, 1, 0, 0, -1, 0, -1, 3, 0, 1, 3, 0, -1, 0});             // the same along x
    add({0, 0, 0, 0, 0, 1, -1, -1, 0, 1, -1, 0, 0, 1, 0, 0});             // at the origin
    add({0, 0, 0, 0, 0, 1, -1, -1, -1e-30f, 1, -1, -1e-30f, 0, 1, 0, 0}); // behind
    add({0, 0, 0, 0, 0, 1, -1, -1, 2, 1, -1, 2, 0, 1, 2, 2});             // `after` is not a hit any more
    for (float bad : {kNaN, std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()})
        for (std::size_t k = 0; k < 6; ++k) {
            std::vector<float> tuple{0, 0, 0, 0.1f, 0.2f, 1, -1, -1, 1, 1, -1, 1, 0, 1, 1, 0};
            tuple[k] = bad;
            in.values.insert(in.values.end(), tuple.begin(), tuple.end());
        }
    expect_within(run_kernel(device, "ray_triangle", in, 9), constant(kNoHit), Bound::exact());
}

// Both sides, any length of the direction, permuted axes: the same t.
TEST_F(Kernel, RayTriangleFromBothSides) {
    Inputs in{16, {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (float way : {1.0f, -1.0f, 0.25f, -4.0f})
            for (bool turned : {false, true}) {
                const auto put_turned = [&](float x, float y, float z) {
                    const float v[3] = {x, y, z};
                    for (std::size_t k = 0; k < 3; ++k) in.values.push_back(v[(k + axis) % 3]);
                };
                put_turned(0, 0, 0), put_turned(0.0625f * way, 0, way), put_turned(-2, -2, 3 * way);
                put_turned(turned ? 1 : 4, turned ? 4 : -1, 3 * way), put_turned(turned ? 4 : 1, turned ? -1 : 4, 3 * way);
                in.values.push_back(0);
            }
    expect_within(run_kernel(device, "ray_triangle", in, 9), constant(3), Bound::relative(2 * kU));
}

} // namespace lightbench::kernels
