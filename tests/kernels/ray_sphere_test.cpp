// Rays against spheres, near and far, inside and tangent, against roots in double and in 60 digits: SP-1, SP-2, SP-3, PR-1.
#include "rays.h"

namespace lightbench::kernels {

namespace {

// (o, d, c, r, after). The discriminant from the cross product, which the kernel does not use.
template <class T> struct Roots {
    T a, reach, root, t0, t1; // reach: |c - o|
    bool sure = true;         // the line is farther from tangent than 8 u reach
};
template <class T> Roots<T> roots(std::span<const T> in) {
    using std::sqrt;
    const Vec<T> d = vec_at(in, 3), f = vec_at(in, 6) - vec_at(in, 0), across = cross(f, d);
    const T a = dot(d, d), b = dot(f, d), square = a * in[9] * in[9] - dot(across, across), reach = length(f);
    const T missed = length(across) / sqrt(a) - in[9];
    Roots<T> r{a, reach, square > 0 ? T(sqrt(square)) : T(0), 0, 0, (missed < 0 ? T(-missed) : missed) > 8 * kU * (reach + in[9])};
    r.t0 = square < 0 ? T(kNoHit) : T((b - r.root) / a);
    r.t1 = square < 0 ? T(kNoHit) : T((b + r.root) / a);
    return r;
}
template <class T> T first_after(std::span<const T> in) {
    const Roots<T> r = roots(in);
    return r.t0 > in[10] ? r.t0 : r.t1 > in[10] ? r.t1 : T(kNoHit);
}

// 8 u |c - o| / cos(incidence); anything where rounding decides whether there is a hit, or which.
double allowed_t(std::span<const float> in, double) {
    const std::vector<double> x(in.begin(), in.end());
    const Roots<double> r = roots(std::span<const double>(x));
    const double allowed = 8 * kU * (r.reach + x[9]) * x[9] / r.root; // 1 / cos = r sqrt(a) / root; t of a d of length sqrt(a)
    if (!r.sure) return 1e300;
    if (r.root == 0) return 0;
    return std::abs(r.t0 - x[10]) < allowed || std::abs(r.t1 - x[10]) < allowed ? 1e300 : allowed;
}

void fill_ray(std::span<float> in, const Vec3& o, const Vec3& d, const Vec3& c, double r) {
    put(in, 0, o);
    put(in, 3, d);
    put(in, 6, c);
    in[9] = static_cast<float>(r);
    in[10] = 0;
}

// From `far` radii away at a point of the sphere's disc; some rays pass by.
Inputs rays_from(double far, unsigned seed, std::size_t count) {
    return generate(count, 11, seed, [=](Random& random, std::span<float> in) {
        const double r = log_uniform(random, 1e-4, 1e4);
        const Vec3 c = random_in_cube(random, 10 * r), way = random_direction(random), o = c - (far * r) * way;
        const Vec3 aim = c + (r * uniform(random, 0, 1.2)) * unit(cross(way, random_direction(random)));
        fill_ray(in, o, unit(aim - o), c, r);
    });
}

// Origins from the centre to a few radii, ordinary roots and later ones.
Inputs rays_about(unsigned seed) {
    return generate(kMillion / 2, 11, seed, [](Random& random, std::span<float> in) {
        const double r = log_uniform(random, 1e-4, 1e4);
        const Vec3 c = random_in_cube(random, r);
        fill_ray(in, c + (r * uniform(random, 0, 3)) * random_direction(random), random_direction(random), c, r);
        in[10] = static_cast<float>(random() % 2 ? 0 : r * uniform(random, -1, 3));
    });
}

// How far from the sphere the box of the point lets it be; 1: the box just touches the sphere. Coordinates are of the given results.
Measure off_sphere(std::size_t point, std::size_t error, bool unit_ball) {
    return [=](std::span<const float> in, std::span<const float> out) {
        if (!(out[0] < kFloatMax)) return 0.0;
        const Vec3 c = unit_ball ? Vec3{0, 0, 0} : vec_of(in, 6), e = vec_of(out, error), g = vec_of(out, point) - c, n = unit(g);
        const double r = unit_ball ? 1 : static_cast<double>(in[9]);
        return over(std::abs(length(g) - r), std::abs(n.x) * e.x + std::abs(n.y) * e.y + std::abs(n.z) * e.z);
    };
}

} // namespace

TEST_F(Kernel, RaySphere) {
    const Oracle first = oracle([]<class T>(std::span<const T> in) { return first_after(in); });
    for (unsigned seed : seeds()) {
        Inputs in = rays_about(seed);
        for (double far : {1.5, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6}) in = in + rays_from(far, seed, kMillion / 8);
        const KernelRun run = run_kernel(device, "ray_sphere", in, 10);
        expect_within(run, first, Bound::function(allowed_t));
        expect_within(run, constant(0), Bound::absolute(1), off_sphere(1, 7, false));
        expect_within(run, constant(1), Bound::absolute(6 * kU),
                      [](std::span<const float>, std::span<const float> out) { return out[0] < kFloatMax ? length(vec_of(out, 4)) : 1; });
        expect_within(run, constant(0), Bound::absolute(1), [](std::span<const float> ray, std::span<const float> out) {
            const double scale = largest(vec_of(ray, 6)) + static_cast<double>(ray[9]);
            return out[0] < kFloatMax ? largest(vec_of(out, 7)) / (12 * kU * scale) : 0; // the error is no excuse
        });
    }
}

// SP-1: rays at the disc hit, from any distance, where rounding leaves no doubt.
TEST_F(Kernel, RaySphereFarAway) {
    for (double far : {1e2, 1e3, 1e4, 1e5, 1e6}) {
        const Inputs in = generate(kMillion / 8, 11, 3, [=](Random& random, std::span<float> tuple) {
            const Vec3 way = random_direction(random), aim = uniform(random, 0, 0.4) * unit(cross(way, random_direction(random)));
            fill_ray(tuple, Vec3{0, 0, 0} - far * way, unit(aim + far * way), {0, 0, 0}, 1);
        });
        expect_within(run_kernel(device, "ray_sphere", in, 10), constant(1), Bound::exact(),
                      [](std::span<const float>, std::span<const float> out) { return out[0] < kFloatMax ? 1 : 0; });
    }
}

// SP-2: a ground of radius 10^3 to 10^9, the camera about 1 above its top; rays straight down, and others.
TEST_F(Kernel, NearSphere) {
    const Inputs in = generate(kMillion, 10, 1, [](Random& random, std::span<float> ray) {
        const double r = log_uniform(random, 1e3, 1e9), height = log_uniform(random, 1e-6, 3e-3) * r;
        const Vec3 up = random() % 4 ? random_direction(random) : Vec3{0, 1, 0};
        put(ray, 0, random_in_cube(random, 1));
        ray[9] = static_cast<float>(r);
        put(ray, 6, vec_of(ray, 0) - (static_cast<double>(ray[9]) + height) * up);
        put(ray, 3, unit(Vec3{0, 0, 0} - up + uniform(random, 0, 1) * random_direction(random)));
    });
    const auto with_after = []<class T>(std::span<const T> x) {
        std::vector<T> all(x.begin(), x.end());
        all.push_back(T(0));
        return all;
    };
    const Oracle t = oracle([=]<class T>(std::span<const T> x) { return first_after(std::span<const T>(with_after(x))); });
    const Bound bound = Bound::function([=](std::span<const float> x, double expected) {
        const std::vector<double> ray(x.begin(), x.end());
        const Roots<double> r = roots(std::span<const double>(ray));
        const double cosine = r.root / ray[9];
        return r.t0 > 0 && expected < 0.1 * ray[9] ? 8 * kU * expected / (cosine * cosine) : 1e300;
    });
    expect_within(run_kernel(device, "near_sphere", in, 1), t, bound);
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
        fill_ray(tuple, {0, 0, 0}, random_direction(random), {0, 0, 0}, 2);
    });
    expect_within(run_kernel(device, "ray_sphere", out_of, 10), constant(2), Bound::relative(8 * kU));
}

// The unit ball for directions of any length: t scales with their inverse.
TEST_F(Kernel, RayBall) {
    const auto as_sphere = []<class T>(std::span<const T> in) {
        return std::vector<T>{in[0], in[1], in[2], in[3], in[4], in[5], T(0), T(0), T(0), T(1), in[6]};
    };
    const Oracle first = oracle([=]<class T>(std::span<const T> in) { return first_after(std::span<const T>(as_sphere(in))); });
    const Bound bound = Bound::function([=](std::span<const float> in, double expected) { return allowed_t(as_sphere(in), expected); });
    for (unsigned seed : seeds()) {
        const Inputs in = generate(kMillion, 7, seed, [](Random& random, std::span<float> ray) {
            const double far = random() % 2 ? uniform(random, 0, 3) : log_uniform(random, 1, 1e6);
            const Vec3 o = far * random_direction(random), d = unit(uniform(random, 0, 1.2) * random_direction(random) - o);
            put(ray, 0, o);
            put(ray, 3, log_uniform(random, 1e-20, 1e15) * d);
            ray[6] = 0;
        });
        const KernelRun run = run_kernel(device, "ray_ball", in, 7);
        expect_within(run, first, bound);
        expect_within(run, constant(0), Bound::absolute(1), off_sphere(1, 4, true));
    }
}

} // namespace lightbench::kernels
