// Rays and tori against samples of the distance in double: TO-1.
#include "measure/numerics/rows.h"
#include "measure/numerics/shapes.h"

#include <numbers>

namespace lightbench::kernels {

double torus_distance(const Vec3& p, double m) {
    return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - m;
}

namespace {

// How far a line gets beyond the surface, from side (1: outside, -1: inside) to the other one, for t in [from, to]: the distance is sampled,
// and its peaks are searched by sections. It changes by no more than the length of the way.
double crossing(const Line& line, double m, double side, double from, double to) {
    constexpr int kSamples = 200;
    const auto beyond = [&](double t) { return -side * torus_distance(line.at(t), m); };
    const double middle = line.nearest(), around = (1.01 + m) / length(line.d);
    const double low = std::max(from, std::min(middle - around, to)), high = std::min(to, std::max(middle + around, from));
    const double step = (high - low) / kSamples, way = step * length(line.d);
    double most = std::max(beyond(low), beyond(high)), before = beyond(low), here = before;
    for (int i = 1; i <= kSamples + 1 && step > 0; ++i) {
        const double next = i <= kSamples ? beyond(low + step * i) : here;
        if (here >= before && here >= next && here > most - way) {
            const double t =
                least_between(std::max(low, low + step * (i - 2)), std::min(high, low + step * i), [&](double x) { return -beyond(x); });
            most = std::max(most, beyond(t));
        }
        before = here;
        here = next;
    }
    return most;
}

} // namespace

double off_torus(const Line& line, double m, double after, double start, double t) {
    const double miss = t == kNoHit ? 0 : std::abs(torus_distance(line.at(t), m));
    const double outside = std::max(miss, crossing(line, m, 1, after, t)), inside = std::max(miss, crossing(line, m, -1, after, t));
    if (t != kNoHit && !(t > after)) return 1 + m;
    return start > 0 ? std::min(outside, std::max(inside, start)) : std::min(inside, std::max(outside, -start));
}

namespace {

double off_result(std::span<const float> in, std::span<const float> out) {
    const Line line = line_of(in);
    const double m = static_cast<double>(in[6]), after = static_cast<double>(in[7]);
    return off_torus(line, m, after, torus_distance(line.at(after), m), static_cast<double>(out[0]));
}

const Bound kTorusBound =
    Bound::function([](std::span<const float> in, double) { return 6 * kU * (1 + static_cast<double>(in[6]) + length(vec_of(in, 0))); });

const Inputs kMinor = only({0.3f, 1e-4f, 0.05f, 0.9f, 1, 1.5f, 30});

Inputs torus_rays(std::size_t count, unsigned seed) {
    const Inputs rays = generate(count / 64, 6, seed, [](Random& random, std::span<float> in) { fill_ray(random, in, 1.5); });
    return rays * kMinor * only({0});
}

Inputs torus_points(std::size_t count, unsigned seed) {
    const Inputs points = generate(count / 4, 3, seed, [](Random& random, std::span<float> p) { put(p, 0, random_at(random, 1e-3, 3)); });
    const Inputs axis = only({0, 1e-30f, 1e-8f, 1}) * only({0, -1e-30f}) * only({-1, 0.01f, 2});
    return (points + axis) * kMinor;
}

double minor_of(std::span<const float> in) {
    return static_cast<double>(in[3]);
}

double off_torus_normal(std::span<const float>, std::span<const float> out) {
    const Vec3 p = vec_of(out, 0), n = vec_of(out, 3);
    const double r = std::hypot(p.x, p.y);
    if (r == 0) return length(n - Vec3{0, 0, p.z < 0 ? -1.0 : 1.0});
    const Vec3 off = {p.x - p.x / r, p.y - p.y / r, p.z};
    return length(n + (-1 / length(off)) * off);
}

} // namespace

Rows torus_rows() {
    const Bound place = Bound::function([](std::span<const float> in, double) { return 4 * kU * (1 + minor_of(in)); });
    const Bound aim = Bound::function([](std::span<const float> in, double) { return 4 * kU * (1 + minor_of(in)) / minor_of(in); });
    const Measure off_surface = [](std::span<const float> in, std::span<const float> out) {
        return torus_distance(vec_of(out, 0), minor_of(in));
    };
    return {{"ray_torus",
             "lib/ray_torus.glsl",
             "o to 1e4 away, |d| in [1e-6, 1e6], m in [1e-4, 30]",
             "ray_torus",
             1,
             torus_rays,
             {{"hit and t", "surface moved by 6 u (1 + m + |o|)", constant(0), kTorusBound, off_result}}},
            {"torus_point",
             "lib/ray_torus.glsl",
             "p in the ball of radius 3, the axis; m in [1e-4, 30]",
             "torus_point",
             6,
             torus_points,
             {{"point", "4 u (1 + m) from the surface", constant(0), place, off_surface},
              {"normal", "4 u (1 + m) / m", constant(0), aim, off_torus_normal}}}};
}

} // namespace lightbench::kernels
