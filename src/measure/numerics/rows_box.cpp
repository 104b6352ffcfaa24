// Rays against the cube and against bounding boxes, whose bounds are about what is in them: BX-1, BX-3.
#include "measure/numerics/rays.h"
#include "measure/numerics/rows.h"

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

Inputs cube_rays(std::size_t count, unsigned seed) {
    const Inputs about = generate(count, 7, seed, [](Random& random, std::span<float> in) {
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
Inputs box_rays(std::size_t count, unsigned seed) {
    return generate(count, 14, seed, [](Random& random, std::span<float> in) {
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

} // namespace

Rows box_rows() {
    return {{"ray_cube",
             "lib/ray_box.glsl",
             "o to 1e4 away, |d| in [1e-6, 1e6], planes and edges",
             "ray_cube",
             8,
             cube_rays,
             {{"t and face", "relative 7 u of t", constant(0), Bound::absolute(1), share_of_face},
              {"point", "12 u (1 + |o|), on its face", constant(0), Bound::absolute(1), off_face}}},
            {"slab",
             "lib/ray_box.glsl",
             "boxes flat too, within 10 of the origin",
             "slab",
             1,
             box_rays,
             {{"entry", "never late; early by 128 u (extent + |o|)", constant(0), Bound::exact(), out_of_bounds}}}};
}

} // namespace lightbench::kernels
