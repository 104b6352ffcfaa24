// Rays against spheres, near and far, inside and tangent, against roots in double and in 60 digits: SP-1, SP-2.
#include "measure/numerics/rays.h"
#include "measure/numerics/rows.h"

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

void put_ray(std::span<float> in, const Vec3& o, const Vec3& d, const Vec3& c, double r) {
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
        put_ray(in, o, unit(aim - o), c, r);
    });
}

// Origins from the centre to a few radii, ordinary roots and later ones.
Inputs rays_about(std::size_t count, unsigned seed) {
    return generate(count, 11, seed, [](Random& random, std::span<float> in) {
        const double r = log_uniform(random, 1e-4, 1e4);
        const Vec3 c = random_in_cube(random, r);
        put_ray(in, c + (r * uniform(random, 0, 3)) * random_direction(random), random_direction(random), c, r);
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

// A ground of radius 10^3 to 10^9, the camera about 1 above its top; rays straight down, and others.
Inputs grounds(std::size_t count, unsigned seed) {
    return generate(count, 10, seed, [](Random& random, std::span<float> ray) {
        const double r = log_uniform(random, 1e3, 1e9), height = log_uniform(random, 1e-6, 3e-3) * r;
        const Vec3 up = random() % 4 ? random_direction(random) : Vec3{0, 1, 0};
        put(ray, 0, random_in_cube(random, 1));
        ray[9] = static_cast<float>(r);
        put(ray, 6, vec_of(ray, 0) - (static_cast<double>(ray[9]) + height) * up);
        put(ray, 3, unit(Vec3{0, 0, 0} - up + uniform(random, 0, 1) * random_direction(random)));
    });
}

Row near_row() {
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
    return {"near_sphere",
            "lib/ray_sphere.glsl",
            "r in [1e3, 1e9], from within 3e-3 r of the surface",
            "near_sphere",
            1,
            grounds,
            {{"t", "relative 8 u / cos^2 of incidence", t, bound}}};
}

// The unit ball for directions of any length: t scales with their inverse.
Inputs ball_rays(std::size_t count, unsigned seed) {
    return generate(count, 7, seed, [](Random& random, std::span<float> ray) {
        const double far = random() % 2 ? uniform(random, 0, 3) : log_uniform(random, 1, 1e6);
        const Vec3 o = far * random_direction(random), d = unit(uniform(random, 0, 1.2) * random_direction(random) - o);
        put(ray, 0, o);
        put(ray, 3, log_uniform(random, 1e-20, 1e15) * d);
        ray[6] = 0;
    });
}

Row ball_row() {
    const auto as_sphere = []<class T>(std::span<const T> in) {
        return std::vector<T>{in[0], in[1], in[2], in[3], in[4], in[5], T(0), T(0), T(0), T(1), in[6]};
    };
    const Oracle first = oracle([=]<class T>(std::span<const T> in) { return first_after(std::span<const T>(as_sphere(in))); });
    const Bound bound = Bound::function([=](std::span<const float> in, double expected) { return allowed_t(as_sphere(in), expected); });
    return {"ray_ball",
            "lib/ray_sphere.glsl",
            "o to 1e6 radii away, |d| in [1e-20, 1e15]",
            "ray_ball",
            7,
            ball_rays,
            {{"t", "8 u |o| / cos(incidence) / |d|", first, bound},
             {"point", "within its error of the sphere", constant(0), Bound::absolute(1), off_sphere(1, 4, true)}}};
}

Row sphere_row() {
    const Oracle first = oracle([]<class T>(std::span<const T> in) { return first_after(in); });
    const Measure normal_length = [](std::span<const float>, std::span<const float> out) {
        return out[0] < kFloatMax ? length(vec_of(out, 4)) : 1;
    };
    const Measure size_of_error = [](std::span<const float> ray, std::span<const float> out) {
        const double scale = largest(vec_of(ray, 6)) + static_cast<double>(ray[9]);
        return out[0] < kFloatMax ? largest(vec_of(out, 7)) / (12 * kU * scale) : 0; // the error is no excuse
    };
    return {"ray_sphere",
            "lib/ray_sphere.glsl",
            "o inside to 1e6 radii away, r in [1e-4, 1e4]",
            "ray_sphere",
            10,
            [](std::size_t count, unsigned seed) {
                Inputs in = rays_about(count / 2, seed);
                for (double far : {1.5, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6}) in = in + rays_from(far, seed, count / 8);
                return in;
            },
            {{"t", "8 u |c - o| / cos(incidence)", first, Bound::function(allowed_t)},
             {"point", "within its error of the sphere", constant(0), Bound::absolute(1), off_sphere(1, 7, false)},
             {"normal's length", "absolute 6 u", constant(1), Bound::absolute(6 * kU), normal_length},
             {"point's error", "at most 12 u (|c| + r)", constant(0), Bound::absolute(1), size_of_error}}};
}

} // namespace

Rows sphere_rows() {
    return {sphere_row(), near_row(), ball_row()};
}

} // namespace lightbench::kernels
