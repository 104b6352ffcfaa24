// Rays that leave surfaces: the origin is beyond its error, scales with the scene, and no convex shape is met again: SP-4, SH-1, SH-4, SC-1.
#include "kernel_test.h"
#include "measure/numerics/rays.h"

namespace lightbench::kernels {

namespace {

constexpr std::size_t kShapes = 1000, kPoints = 1000;
// Below this cosine the rounding of w.n and of n decides which side a direction leaves to.
constexpr float kGrazing = 0x1p-20f;

// A rotation and scales, all shapes from 1e-4 to 1e4, somewhere within 30 of their sizes.
struct Placement {
    Vec3 axes[3]; // columns of world_from_object
    Vec3 center;
    double size;
};
Placement random_placement(Random& random) {
    Placement p{};
    p.size = log_uniform(random, 1e-4, 1e4);
    const Vec3 x = random_direction(random), y = unit(cross(x, random_direction(random)));
    const Vec3 frame[3] = {x, y, cross(x, y)};
    for (std::size_t k = 0; k < 3; ++k) p.axes[k] = (p.size * log_uniform(random, 0.1, 1)) * frame[k];
    p.center = (p.size * uniform(random, 0, 30)) * random_direction(random);
    return p;
}
Vec3 placed(const Placement& p, const Vec3& q) {
    return p.center + q.x * p.axes[0] + q.y * p.axes[1] + q.z * p.axes[2];
}

// world_from_object and its inverse, by columns; the axes are orthogonal.
void put_matrices(std::span<float> to, std::size_t at, const Placement& p) {
    Vec3 rows[3];
    for (std::size_t k = 0; k < 3; ++k) {
        put(to, at + 3 * k, p.axes[k]);
        rows[k] = (1 / dot(p.axes[k], p.axes[k])) * p.axes[k];
    }
    put(to, at + 9, p.center);
    put(to, at + 12, {rows[0].x, rows[1].x, rows[2].x});
    put(to, at + 15, {rows[0].y, rows[1].y, rows[2].y});
    put(to, at + 18, {rows[0].z, rows[1].z, rows[2].z});
    put(to, at + 21, {-dot(rows[0], p.center), -dot(rows[1], p.center), -dot(rows[2], p.center)});
}

// From up to 100 sizes away, some from inside, at the shape.
void put_ray(std::span<float> to, Random& random, const Placement& p) {
    put(to, 0,
        random() % 4 ? p.center + (p.size * log_uniform(random, 2, 100)) * random_direction(random)
                     : placed(p, random_in_cube(random, 0.5)));
    put(to, 3, unit(placed(p, random_in_cube(random, 0.7)) - vec_of(to, 0)));
}
void put_directions(std::span<float> to, std::size_t at, Random& random) {
    for (std::size_t i = 0; i < 4; ++i) put(to, at + 3 * i, random_direction(random));
}

// kShapes shapes of kPoints points with four directions each; a part of the shapes at a time, for the range of storage buffers.
using Fill = std::function<void(Random&, std::span<float>, const Placement&)>;
void expect_left(gpu::Device& device, const std::string& kernel, std::size_t arity, std::size_t results, const Fill& fill) {
    constexpr std::size_t kPart = kShapes / 4;
    for (unsigned seed : seeds())
        for (std::size_t part = 0; part < 4; ++part) {
            std::size_t i = 0;
            Placement p{};
            const Inputs in =
                generate(kPart * kPoints, arity, seed * 4 + static_cast<unsigned>(part), [&](Random& random, std::span<float> tuple) {
                    if (i++ % kPoints == 0) p = random_placement(random);
                    fill(random, tuple, p);
                });
            const KernelRun run = run_kernel(device, kernel, in, results);
            std::size_t hit = 0, grazing = 0;
            for (std::size_t k = 0; k < in.count(); ++k) {
                hit += run.result(k)[0] < kFloatMax;
                grazing += run.result(k)[0] < kFloatMax && results > 2 && run.result(k)[2] < kGrazing;
            }
            EXPECT_GT(hit, in.count() / 4);
            EXPECT_LT(grazing, in.count() / 10000);
            expect_within(run, constant(0), Bound::exact(), [=](std::span<const float>, std::span<const float> out) {
                const bool left = out[0] < kFloatMax && !(results > 2 && out[2] < kGrazing);
                return left ? static_cast<double>(out[1]) : 0;
            });
        }
}

} // namespace

TEST_F(Kernel, OffsetOrigin) {
    expect_rows(device, "offset_origin");
}

// SC-1: a scene that is 2^k times as large has its origins 2^k times as far, bit for bit.
TEST_F(Kernel, OffsetOriginScales) {
    const Inputs in = row_of("offset_origin").inputs(kMillion, 9);
    const std::vector<float> once = run_kernel(device, "offset_origin", in, 3).results;
    for (float scale : {0x1p-30f, 0.5f, 0x1p30f}) {
        Inputs scaled = in;
        for (std::size_t i = 0; i < scaled.values.size(); ++i)
            if (i % 12 < 6) scaled.values[i] *= scale;
        const std::vector<float> there = run_kernel(device, "offset_origin", scaled, 3).results;
        std::size_t different = 0;
        for (std::size_t i = 0; i < once.size(); ++i) different += there[i] != once[i] * scale && std::abs(once[i]) > 0x1p-90f;
        EXPECT_EQ(different, 0u) << "scale " << scale;
    }
}

TEST_F(Kernel, SpheresAreLeft) {
    expect_left(device, "leave_sphere", 22, 3, [](Random& random, std::span<float> in, const Placement& p) {
        const double r = length(p.axes[0]);
        Placement ball = p;
        ball.size = r;
        for (Vec3& axis : ball.axes) axis = r * unit(axis);
        put_ray(in, random, ball);
        put(in, 6, p.center);
        in[9] = static_cast<float>(r);
        put_directions(in, 10, random);
    });
}

TEST_F(Kernel, TrianglesAreLeft) {
    expect_left(device, "leave_triangle", 27, 2, [](Random& random, std::span<float> in, const Placement& p) {
        const double a = uniform(random, 0, 1), b = uniform(random, 0, 1 - a);
        const Vec3 v0 = placed(p, {-1, -1, 0.3}), v1 = placed(p, {1, -0.8, -1});
        const Vec3 v2 = v0 + uniform(random, 0, 1) * (v1 - v0) + (p.size * log_uniform(random, 1e-4, 1)) * random_direction(random);
        put(in, 0, p.center + (p.size * log_uniform(random, 1, 100)) * random_direction(random));
        put(in, 3, unit(v0 + a * (v1 - v0) + b * (v2 - v0) - vec_of(in, 0)));
        put(in, 6, v0);
        put(in, 9, v1);
        put(in, 12, v2);
        put_directions(in, 15, random);
    });
}

static void fill_placed(Random& random, std::span<float> in, const Placement& p) {
    put_ray(in, random, p);
    put_matrices(in, 6, p);
    put_directions(in, 30, random);
}

TEST_F(Kernel, EllipsoidsAreLeft) {
    expect_left(device, "leave_ball", 42, 3, fill_placed);
}

TEST_F(Kernel, BoxesAreLeft) {
    expect_left(device, "leave_cube", 42, 3, fill_placed);
}

// SH-4: a second surface 32 floats of the largest coordinate away is seen, for directions up to 45 degrees from the normal.
TEST_F(Kernel, NarrowGapsAreSeen) {
    for (unsigned seed : seeds()) {
        const Inputs in = generate(kMillion, 21, seed, [](Random& random, std::span<float> tuple) {
            const Placement p = random_placement(random);
            const Vec3 v0 = placed(p, {-1, -1, 0}), v1 = placed(p, {1, -1, 0}), v2 = placed(p, {0, 1, 0}), n = unit(p.axes[2]);
            const double a = uniform(random, 0.2, 0.4), b = uniform(random, 0.2, 0.4);
            const Vec3 aim = v0 + a * (v1 - v0) + b * (v2 - v0);
            put(tuple, 0, aim + p.size * unit(n + 0.9 * random_direction(random)));
            put(tuple, 3, unit(aim - vec_of(tuple, 0)));
            put(tuple, 6, v0);
            put(tuple, 9, v1);
            put(tuple, 12, v2);
            const float reach = static_cast<float>(std::max({largest(v0), largest(v1), largest(v2)}));
            const double ulp = static_cast<double>(std::nextafter(reach, kFloatMax) - reach);
            put(tuple, 15, (32 * ulp) * n);
            put(tuple, 18, uniform(random, 0, 1) * unit(cross(n, random_direction(random))));
        });
        expect_within(
            run_kernel(device, "leave_gap", in, 2), constant(1), Bound::exact(),
            [](std::span<const float>, std::span<const float> out) { return out[0] < kFloatMax ? static_cast<double>(out[1]) : 1; });
    }
}

} // namespace lightbench::kernels
