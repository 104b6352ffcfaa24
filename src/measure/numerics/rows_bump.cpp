// Tilted normals and tangent frames against double: BM-2, BM-3.
#include "measure/numerics/frames.h"
#include "measure/numerics/rows.h"

namespace lightbench::kernels {

namespace frames {
namespace {

Measure off_unit(std::size_t first) {
    return [=](std::span<const float>, std::span<const float> out) { return length(at(out, first)) - 1; };
}

using Pick = Vector (*)(std::span<const float> in, std::span<const float> out);

Vector normal_of(std::span<const float> in, std::span<const float>) {
    return at(in, 0);
}
Vector tangent_of(std::span<const float>, std::span<const float> out) {
    return at(out, 0);
}
Vector bitangent_of(std::span<const float>, std::span<const float> out) {
    return at(out, 3);
}

Claim perpendicular(const char* what, Pick a, Pick b) {
    return {what, "absolute 4 u", constant(0), Bound::absolute(4 * kU),
            [=](std::span<const float> in, std::span<const float> out) { return dot(a(in, out), b(in, out)); }};
}

double wrong_hand(std::span<const float> in, std::span<const float> out) {
    const Vector a = at(in, 0), b = at(out, 0), c = at(out, 3);
    const double turn = c[0] * (a[1] * b[2] - a[2] * b[1]) + c[1] * (a[2] * b[0] - a[0] * b[2]) + c[2] * (a[0] * b[1] - a[1] * b[0]);
    return (turn < 0) == (in[6] < 0) ? 0 : 1;
}

Row frame_row() {
    return {"tangent_frame",
            "lib/bump.glsl",
            "n unit, t of any length, down to 1e-9 off n",
            "tangent_frame",
            6,
            [](std::size_t count, unsigned seed) { return generate(count, 7, seed, fill_frame); },
            {{"t's length", "absolute 4 u", constant(0), Bound::absolute(4 * kU), off_unit(0)},
             {"b's length", "absolute 4 u", constant(0), Bound::absolute(4 * kU), off_unit(3)},
             perpendicular("n.t", normal_of, tangent_of),
             perpendicular("n.b", normal_of, bitangent_of),
             perpendicular("t.b", tangent_of, bitangent_of),
             {"handedness", "exact", constant(0), Bound::exact(), wrong_hand}}};
}

double along(std::span<const float> in) {
    return dot(unit(at(in, 0)), at(in, 3));
}
Vector raised(std::span<const float> in) {
    const Vector n = unit(at(in, 0));
    return plus(n, plus(at(in, 3), n, -along(in)), -1);
}

Inputs gradients(std::size_t count, unsigned seed) {
    return generate(count, 6, seed, [](Random& random, std::span<float> values) {
        const Vector n = random_unit(random), any = random_unit(random);
        const Vector g = plus(any, n, -dot(n, any) * (uniform(random, -1, 1) < 0 ? 1 : 0));
        put(values.subspan(0, 3), n);
        put(values.subspan(3, 3), plus({0, 0, 0}, g, log_uniform(random, 1e-6, 1e4)));
    });
}

Row perturb_row() {
    const Bound bound =
        Bound::function([](std::span<const float> in, double) { return (8 + 4 * std::abs(along(in)) / length(raised(in))) * kU; });
    const Measure off = [](std::span<const float> values, std::span<const float> out) {
        return length(plus(at(out, 0), unit(raised(values)), -1));
    };
    return {"perturb_normal",
            "lib/bump.glsl",
            "n unit, |g| in [1e-6, 1e4]",
            "perturb_normal",
            3,
            gradients,
            {{"length", "absolute 6 u", constant(0), Bound::absolute(6 * kU), off_unit(0)},
             {"direction", "(8 + 4 |g.n| / |n - g|) u", constant(0), bound, off}}};
}

// n is what a bump made of the geometric normal, which faces the viewer.
Inputs facings(std::size_t count, unsigned seed) {
    return generate(count, 9, seed, [](Random& random, std::span<float> values) {
        const Vector g = random_unit(random), any = random_unit(random), other = random_unit(random);
        const Vector n = plus(plus(any, g, -dot(g, any)), g, log_uniform(random, 1e-3, 1e3));
        put(values.subspan(0, 3), unit(n));
        put(values.subspan(3, 3), g);
        put(values.subspan(6, 3), unit(plus(other, g, dot(g, other) < 0 ? -2 * dot(g, other) : 0)));
    });
}

double turned_away(std::span<const float> values, std::span<const float> out) {
    return std::min(0.0, dot(at(out, 0), at(values, 6)));
}
double moved(std::span<const float> values, std::span<const float> out) {
    return length(plus(at(out, 0), at(values, 0), -1));
}
double move_bound(std::span<const float> values, double) {
    const double c = -dot(at(values, 0), at(values, 6));
    return c < -4 * kU ? 0 : 2 * c + 16 * kU;
}

Row facing_row() {
    return {"keep_facing",
            "lib/bump.glsl",
            "n, g, v unit",
            "keep_facing",
            3,
            facings,
            {{"length", "absolute 6 u", constant(0), Bound::absolute(6 * kU), off_unit(0)},
             {"faces v", "absolute 4 u", constant(0), Bound::absolute(4 * kU), turned_away},
             {"moved by", "2 |n.v| + 16 u if it faced away, else 0", constant(0), Bound::function(move_bound), moved}}};
}

// n less the gradient is the normal that the texel says: x along t, y along b, z along n.
Row normal_map_row() {
    const auto slope = [](std::size_t i) {
        return oracle([=](auto values) { return -values[9] * (2 * values[i] - 1) / (2 * values[2] - 1); });
    };
    const Bound bound = Bound::function([](std::span<const float> values, double) {
        const double z = 2 * static_cast<double>(values[2]) - 1;
        return 8 * kU / z / z;
    });
    return {"normal_map_gradient",
            "lib/bump.glsl",
            "texel's z in [0.52, 1], strength to 2",
            "normal_map_gradient",
            3,
            [](std::size_t count, unsigned seed) {
                return generate(count / 2, 10, seed, [](Random& random, std::span<float> values) {
                    for (std::size_t i = 0; i < 3; ++i) values[i] = static_cast<float>(uniform(random, i == 2 ? 0.52 : 0, 1));
                    put(values.subspan(3, 3), {1, 0, 0});
                    put(values.subspan(6, 3), {0, 1, 0});
                    values[9] = static_cast<float>(uniform(random, -2, 2));
                });
            },
            {{"along t", "8 u / (2z - 1)^2", slope(0), bound, component(0)},
             {"along b", "8 u / (2z - 1)^2", slope(1), bound, component(1)},
             {"along n", "exact", constant(0), Bound::exact(), component(2)}}};
}

} // namespace
} // namespace frames

Rows bump_rows() {
    return {frames::perturb_row(), frames::facing_row(), frames::frame_row(), frames::normal_map_row()};
}

} // namespace lightbench::kernels
