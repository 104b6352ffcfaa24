// Rays against triangles: t and barycentrics against determinants in double and 60 digits, closed meshes without leaks: PL-1, PL-2, PL-5, PL-6.
#include "rays.h"

namespace lightbench::kernels {

namespace {

// (o, d, v0, v1, v2, after): Cramer's rule on o + t d = v0 + b1 (v1 - v0) + b2 (v2 - v0).
template <class T> struct Meeting {
    T t, b1, b2;
    Vec<T> u, v, normal; // edges from v0, twice the area
};
template <class T> Meeting<T> meeting(std::span<const T> in) {
    const Vec<T> o = vec_at(in, 0), d = vec_at(in, 3), v0 = vec_at(in, 6), u = vec_at(in, 9) - v0, v = vec_at(in, 12) - v0;
    const Vec<T> normal = cross(u, v), w = o - v0, q = cross(w, d);
    const T determinant = -dot(d, normal);
    return {T(dot(w, normal) / determinant), T(dot(v, q) / determinant), T(-dot(u, q) / determinant), u, v, normal};
}

// What rounding may do: vertices are off by 16 u of the largest coordinate relative to o, edge functions by 4 u of their products.
struct Doubt {
    double t, b;
};
Doubt doubt(std::span<const double> in, const Meeting<double>& m) {
    const Vec3 o = vec_at(in, 0), d = unit(vec_at(in, 3)), corner = vec_at(in, 6) - o;
    const double reach = std::max({largest(corner), largest(corner + m.u), largest(corner + m.v)}), area = length(m.normal);
    const double longest = std::max({length(m.u), length(m.v), length(m.u - m.v)});
    const double cosine = std::abs(dot(m.normal, d)) / area, off = 16 * kU * (reach + longest * longest * longest / area) / cosine;
    return {off / length(vec_at(in, 3)), off * longest / area};
}

bool hits(const Meeting<double>& m, double margin) {
    return m.b1 > margin && m.b2 > margin && m.b1 + m.b2 < 1 - margin;
}
bool may_hit(const Meeting<double>& m, double margin) {
    return !(m.b1 < -margin || m.b2 < -margin || m.b1 + m.b2 > 1 + margin);
}

// 0: as it must be; a number above 1: not. Between: t as a share of what it may be off.
double share_of_t(std::span<const float> tuple, std::span<const float> out) {
    const std::vector<double> in(tuple.begin(), tuple.end());
    const Meeting<double> m = meeting(std::span<const double>(in));
    if (length(m.normal) == 0) return 0; // rounding has made it a line
    const Doubt off = doubt(in, m);
    const bool hit = out[0] < kFloatMax;
    if (!hit) return hits(m, off.b) && m.t > in[15] + off.t ? 1e3 : 0;
    if (!may_hit(m, off.b) || m.t < in[15] - off.t) return 1e6;
    return over(std::abs(static_cast<double>(out[0]) - m.t), off.t);
}
double share_of_b(std::span<const float> tuple, std::span<const float> out) {
    const std::vector<double> in(tuple.begin(), tuple.end());
    const Meeting<double> m = meeting(std::span<const double>(in));
    if (!(out[0] < kFloatMax) || length(m.normal) == 0) return 0;
    const double off = std::max(std::abs(static_cast<double>(out[1]) - m.b1), std::abs(static_cast<double>(out[2]) - m.b2));
    return over(off, doubt(in, m).b + 4 * kU);
}

// How far from the plane, as a share of what the error of the point lets it be (PL-5).
double share_of_plane(std::span<const float> tuple, std::span<const float> out) {
    const std::vector<double> in(tuple.begin(), tuple.end());
    const Meeting<double> m = meeting(std::span<const double>(in));
    if (!(out[0] < kFloatMax)) return 0;
    const Vec3 e = vec_of(out, 6), w = vec_of(out, 3) - vec_of(tuple, 6), n = m.normal;
    return over(std::abs(dot(w, n)), std::abs(n.x) * e.x + std::abs(n.y) * e.y + std::abs(n.z) * e.z);
}

// Triangles of any size and place; thin: squashed towards one edge.
Inputs triangles(unsigned seed, double thin) {
    return generate(kMillion / 2, 16, seed, [=](Random& random, std::span<float> in) {
        const double size = log_uniform(random, 1e-3, 1e3), far = size * log_uniform(random, 0.1, 1e3);
        const Vec3 v0 = random_in_cube(random, far), v1 = v0 + size * random_direction(random);
        const Vec3 v2 = v0 + uniform(random, 0, 1) * (v1 - v0) + (size * log_uniform(random, thin, 1)) * random_direction(random);
        const double a = uniform(random, -0.2, 1), b = uniform(random, -0.2, 1);
        const Vec3 o = random_in_cube(random, far), aim = v0 + a * (v1 - v0) + b * (v2 - v0);
        put(in, 0, o);
        put(in, 3, unit(aim - o));
        put(in, 6, v0);
        put(in, 9, v1);
        put(in, 12, v2);
        in[15] = 0;
    });
}

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
    for (unsigned seed : seeds())
        for (double thin : {0.1, 1e-6}) {
            const KernelRun run = run_kernel(device, "ray_triangle", triangles(seed, thin), 9);
            expect_within(run, constant(0), Bound::absolute(1), share_of_t);
            expect_within(run, constant(0), Bound::absolute(1), share_of_b);
            expect_within(run, constant(0), Bound::absolute(1), share_of_plane);
        }
}

// The oracle in double is as good as in 60 digits: t of triangles that are not thin.
TEST_F(Kernel, RayTriangleOracle) {
    KernelRun run = run_kernel(device, "ray_triangle", triangles(7, 0.1), 9);
    const Oracle t = oracle([]<class T>(std::span<const T> in) { return meeting(in).t; });
    expect_within(run, t, Bound::function([](std::span<const float> tuple, double) {
                      const std::vector<double> in(tuple.begin(), tuple.end());
                      return doubt(in, meeting(std::span<const double>(in))).t;
                  }),
                  [](std::span<const float> tuple, std::span<const float> out) {
                      const std::vector<double> in(tuple.begin(), tuple.end());
                      return out[0] < kFloatMax ? static_cast<double>(out[0]) : meeting(std::span<const double>(in)).t;
                  });
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
