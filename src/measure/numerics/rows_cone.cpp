// Rays and truncated cones against sections of a convex function in double: CY-1, CO-1, CO-2.
#include "measure/numerics/rows.h"
#include "measure/numerics/shapes.h"

namespace lightbench::kernels {

Inputs cone_radii() {
    return only({1}) * only({1}) + only({0}) * only({1}) + only({1}) * only({0}) + only({0.3f}) * only({1}) +
           only({1}) * only({0.99999994f}) + only({0x1p-20f}) * only({1});
}

namespace {

// How far a point is outside of the mantle and of the slab; both grow as convex functions along any line.
struct Cone {
    double mean, slope;
    double mantle(const Vec3& p) const { return (std::hypot(p.x, p.y) - (mean + slope * p.z)) / std::hypot(1.0, slope); }
    double slab(const Vec3& p) const { return std::abs(p.z) - 1; }
    double outside(const Vec3& p) const { return std::max(mantle(p), slab(p)); }
};

Cone cone_of(float r0, float r1) {
    return {0.5 * (static_cast<double>(r0) + static_cast<double>(r1)), 0.5 * (static_cast<double>(r1) - static_cast<double>(r0))};
}

// Where the line goes in and out of the solid, and how deep it gets.
struct Passage {
    double deepest = 0, depth = 0, enter = 0, leave = 0;
};

Passage passage(const Line& line, const Cone& cone) {
    const auto outside = [&](double t) { return cone.outside(line.at(t)); };
    const double middle = line.nearest(), around = 2 / length(line.d), low = middle - around, high = middle + around;
    Passage way;
    way.deepest = least_between(low, high, outside);
    way.depth = -outside(way.deepest);
    way.enter = root_between(low, way.deepest, outside);
    way.leave = root_between(high, way.deepest, outside);
    return way;
}

// How far a point is from a part of the surface.
double off_part(const Cone& cone, const Vec3& p, double part) {
    if (part == 0) return std::max(std::abs(cone.mantle(p)), cone.slab(p));
    return std::max(std::abs(p.z - (part == 1 ? -1 : 1)), cone.mantle(p));
}

// How far the surface would have to be moved for this answer to be right. Arguments as those of the kernel ray_cone.
double off_cone(std::span<const float> in, std::span<const float> out) {
    const Line line = line_of(in);
    const Cone cone = cone_of(in[6], in[7]);
    const bool capped = in[8] != 0.0f;
    const double after = static_cast<double>(in[9]), t = static_cast<double>(out[0]);
    const Passage way = passage(line, cone);
    const double start = cone.outside(line.at(after));
    const auto passed_by = [&](double root, double clear) { // what it takes to overlook a root
        return std::max(0.0, std::min({way.depth, clear, capped ? 1.0 : -cone.slab(line.at(root))}));
    };
    const double no_entry = after < way.deepest ? passed_by(way.enter, start) : 0;
    const double no_exit = passed_by(way.leave, after < way.deepest ? 1 : -start);
    if (t == kNoHit) return std::max(no_entry, no_exit);
    if (!(t > after) || (!capped && out[1] != 0.0f)) return 1;
    return std::max(off_part(cone, line.at(t), static_cast<double>(out[1])), t < way.deepest ? 0 : no_entry);
}

const Bound kConeBound = Bound::function([](std::span<const float> in, double) { return 12 * kU * (1 + length(vec_of(in, 0))); });

double off_normal(std::span<const float> in, std::span<const float> out) {
    const Vec3 p = vec_of(out, 0), n = vec_of(out, 3);
    const double slope = cone_of(in[3], in[4]).slope, r = std::hypot(p.x, p.y);
    if (in[5] != 0.0f) return length(n - Vec3{0, 0, in[5] == 1.0f ? -1.0 : 1.0});
    if (r == 0) return length(n - Vec3{0, 0, slope > 0 ? -1.0 : 1.0});
    return length(n - Vec3{p.x / r, p.y / r, -slope});
}

Inputs cone_rays(std::size_t count, unsigned seed) {
    const Inputs rays = generate(count / 64, 6, seed, [](Random& random, std::span<float> in) { fill_ray(random, in, 1.5); });
    return rays * cone_radii() * only({0, 1}) * only({0});
}

Inputs cone_points(std::size_t count, unsigned seed) {
    const Inputs points = generate(count / 8, 3, seed, [](Random& random, std::span<float> p) { put(p, 0, random_at(random, 1e-3, 3)); });
    const Inputs axis = only({0, 1e-30f, 1e-8f}) * only({0, -1e-30f}) * only({-1.001f, -1, 0, 1, 1.001f});
    return (points + axis) * cone_radii() * only({0, 1, 2});
}

} // namespace

Rows cone_rows() {
    const Measure off_surface = [](std::span<const float> in, std::span<const float> out) {
        return off_part(cone_of(in[3], in[4]), vec_of(out, 0), static_cast<double>(in[5]));
    };
    return {{"ray_cone",
             "lib/ray_cone.glsl",
             "o to 1e4 away, |d| in [1e-6, 1e6], cones, cylinders, caps",
             "ray_cone",
             2,
             cone_rays,
             {{"hit and t", "surface moved by 12 u (1 + |o|)", constant(0), kConeBound, off_cone}}},
            {"cone_point",
             "lib/ray_cone.glsl",
             "p in the ball of radius 3, the axis",
             "cone_point",
             6,
             cone_points,
             {{"point", "absolute 11 u from the surface", constant(0), Bound::absolute(11 * kU), off_surface},
              {"normal", "absolute 8 u", constant(0), Bound::absolute(8 * kU), off_normal}}}};
}

} // namespace lightbench::kernels
