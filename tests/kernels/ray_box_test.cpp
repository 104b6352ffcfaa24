// Rays against the cube and against bounding boxes, whose bounds are about what is in them: BX-1, BX-2, BX-3, PR-1.
#include "rays.h"

namespace lightbench::kernels {

namespace {

struct Span {
    double enter, leave;
    bool meets() const { return enter <= leave; }
};

// The slab lo <= o + t d <= hi.
Span slab_of(double lo, double hi, double o, double d) {
    if (d == 0) return o >= lo && o <= hi ? Span{-1e300, 1e300} : Span{1e300, -1e300};
    const double a = (lo - o) / d, b = (hi - o) / d;
    return {std::min(a, b), std::max(a, b)};
}
Span common(const Span& a, const Span& b) {
    return {std::max(a.enter, b.enter), std::min(a.leave, b.leave)};
}

// (o, d) and a box that is `grow` larger on every side.
Span through_box(const Vec3& lo, const Vec3& hi, const Vec3& o, const Vec3& d, double grow) {
    return common(slab_of(lo.x - grow, hi.x + grow, o.x, d.x),
                  common(slab_of(lo.y - grow, hi.y + grow, o.y, d.y), slab_of(lo.z - grow, hi.z + grow, o.z, d.z)));
}

constexpr Vec3 kLow{-1, -1, -1}, kHigh{1, 1, 1};

double component_of(const Vec3& v, std::size_t axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// (o, d, after) -> t, face: 1e6 for a wrong decision, else how far the plane of the face is from the right t, as a share of 7 u t.
double share_of_face(std::span<const float> in, std::span<const float> out) {
    const auto flushed = [&](std::size_t k) { return std::abs(in[k]) < 0x1p-126f ? 0 : static_cast<double>(in[k]); };
    const Vec3 o = vec_of(in, 0), d{flushed(3), flushed(4), flushed(5)};
    if (largest(d) == 0) return 0; // not traceable
    const Span way = through_box(kLow, kHigh, o, d, 0);
    const double after = static_cast<double>(in[6]), close = 14 * kU * (std::abs(way.enter) + std::abs(way.leave));
    const bool inside = largest(o) <= 1, tight = !inside && std::abs(way.leave - way.enter) <= close;
    const bool hit = out[0] < kFloatMax, must = way.meets() && way.leave > after;
    if (tight && !hit) return 0;
    if (hit != must && !tight) return std::abs(way.leave - after) <= close && after > 0 ? 0 : 1e6;
    if (!hit) return 0;
    const std::size_t face = static_cast<std::size_t>(out[1]), axis = face / 2;
    if (component_of(d, axis) == 0) return 1e6;
    const double plane = ((face % 2 ? 1.0 : -1.0) - component_of(o, axis)) / component_of(d, axis);
    const double t = way.enter > after ? way.enter : way.leave;
    if (std::abs(way.enter - after) <= close && after > 0) return 0;
    if (!(out[0] > in[6])) return 1e6;
    return over(std::max(std::abs(plane - t) / 2, std::abs(plane - static_cast<double>(out[0]))),
                7 * kU * std::max(std::abs(t), tight ? close / kU : 0));
}

// The point is on its face, and not outside of the cube.
double off_face(std::span<const float> in, std::span<const float> out) {
    if (!(out[0] < kFloatMax)) return 0;
    const std::size_t face = static_cast<std::size_t>(out[1]);
    const Vec3 p = vec_of(out, 2), n = vec_of(out, 5), exact = vec_of(in, 0) + static_cast<double>(out[0]) * vec_of(in, 3);
    if (component_of(p, face / 2) != (face % 2 ? 1 : -1) || largest(p) > 1 || dot(p, n) != 1 || length(n) != 1) return 1e6;
    return over(largest(p - exact), 12 * kU * (1 + largest(vec_of(in, 0))));
}

Inputs cube_rays(unsigned seed) {
    const Inputs about = generate(kMillion, 7, seed, [](Random& random, std::span<float> in) {
        const Vec3 o = random() % 3 ? log_uniform(random, 1, 1e4) * random_direction(random) : random_in_cube(random, 1);
        put(in, 0, o);
        const Vec3 aim = random_in_cube(random, 1.2);
        put(in, 3, log_uniform(random, 1e-6, 1e6) * unit(aim - vec_of(in, 0)));
        in[6] = 0;
    });
    const Inputs place = only({0, -0.0f, 1, -1, 0.5f, 3, -3}), way = only({0, -0.0f, 1, -1, 0.5f, 1e-30f, -1e-40f});
    return about + place * place * place * way * way * way * only({0});
}

// (lo, hi, o, d, extent, t_max); many flat boxes, many directions along axes, origins on planes.
Inputs box_rays(unsigned seed) {
    return generate(kMillion, 14, seed, [](Random& random, std::span<float> in) {
        const double size = log_uniform(random, 1e-4, 10);
        const Vec3 a = random_in_cube(random, 10);
        put(in, 0, a);
        put(in, 3, a + Vec3{uniform(random, 0, size), uniform(random, 0, size), uniform(random, 0, size)});
        const Vec3 aim = a + random_in_cube(random, 2 * size),
                   d = unit(random() % 2 ? aim - random_in_cube(random, 20) : random_direction(random));
        put(in, 9, d);
        for (std::size_t k = 0; k < 3; ++k) {
            if (random() % 8 == 0) in[3 + k] = in[k];
            if (random() % 8 == 0) in[9 + k] = random() % 2 ? 0 : -0.0f;
        }
        put(in, 9, unit(vec_of(in, 9)));
        put(in, 6, aim - uniform(random, -1, 20) * vec_of(in, 9));
        for (std::size_t k = 0; k < 3; ++k)
            if (random() % 8 == 0) in[6 + k] = in[3 * (random() % 2) + k];
        in[12] = static_cast<float>(std::max(largest(vec_of(in, 0)), largest(vec_of(in, 3))));
        in[13] = random() % 4 ? kFloatMax : static_cast<float>(uniform(random, 0, 20));
    });
}

// Not later than where the ray enters the box, not earlier than where it enters one that is larger by twice the margin.
double out_of_bounds(std::span<const float> in, std::span<const float> out) {
    const Vec3 lo = vec_of(in, 0), hi = vec_of(in, 3), o = vec_of(in, 6), d = vec_of(in, 9);
    const double t_max = static_cast<double>(in[13]), got = static_cast<double>(out[0]);
    const Span ahead{0, t_max}, inner = common(ahead, through_box(lo, hi, o, d, 0));
    const Span outer = common(ahead, through_box(lo, hi, o, d, 128 * kU * (static_cast<double>(in[12]) + largest(o))));
    if (inner.meets() && got > inner.enter) return 1;
    return outer.meets() ? got < outer.enter : got < kNoHit;
}

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
    for (unsigned seed : seeds()) {
        const KernelRun run = run_kernel(device, "ray_cube", cube_rays(seed), 8);
        expect_within(run, constant(0), Bound::absolute(1), share_of_face);
        expect_within(run, constant(0), Bound::absolute(1), off_face);
    }
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
    for (unsigned seed : seeds()) expect_within(run_kernel(device, "slab", box_rays(seed), 1), constant(0), Bound::exact(), out_of_bounds);
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
