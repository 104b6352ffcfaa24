// Random facets, and grazing ones whose cosines are floats.
#include "measure/numerics/facets.h"

#include <algorithm>

namespace lightbench::kernels {

namespace {

using Double3 = Vec<double>;

Double3 random_unit(Random& random) {
    double d[3];
    unit_vector(random, d);
    return {d[0], d[1], d[2]};
}

Double3 turned(const Double3& from, const Double3& towards, double angle) {
    return {std::cos(angle) * from.x + std::sin(angle) * towards.x, std::cos(angle) * from.y + std::sin(angle) * towards.y,
            std::cos(angle) * from.z + std::sin(angle) * towards.z};
}

Double3 perpendicular(Random& random, const Double3& to) {
    return unit(cross(to, random_unit(random)));
}

void put(std::span<float> out, const Double3& v) {
    out[0] = static_cast<float>(v.x);
    out[1] = static_cast<float>(v.y);
    out[2] = static_cast<float>(v.z);
}

} // namespace

void fill_facet(Random& random, std::span<float> in, Facets d) {
    const double m = log_uniform(random, 1e-3, 1), slope = m * std::sqrt(uniform(random, 0, 20));
    const double alpha = d == Facets::beckmann ? std::atan(slope) : std::min(slope, 1.55);
    Double3 n, l, v;
    do {
        const Double3 h = random_unit(random), side = perpendicular(random, h);
        const double half = random() % 2 == 0 ? uniform(random, 0, 1.57) : log_uniform(random, 1e-4, 1.57);
        n = turned(h, perpendicular(random, h), alpha);
        l = turned(h, side, half);
        v = turned(h, side, -half);
    } while (dot(n, l) < 1e-5 || dot(n, v) < 1e-5);
    put(in.subspan(0, 3), n);
    put(in.subspan(3, 3), l);
    put(in.subspan(6, 3), v);
    in[9] = static_cast<float>(m);
    in[10] = static_cast<float>(0.25 / (m * m));
    in[11] = static_cast<float>(log_uniform(random, 1.01, 30));
    in[12] = in[13] = 1.5f;
}

std::vector<float> exact_geometry(float nl, float nv, double azimuth, float m, float lobe, float ior) {
    const auto across = [](float z) { return std::sqrt((1 - static_cast<double>(z)) * (1 + static_cast<double>(z))); };
    return {0,
            0,
            1,
            static_cast<float>(across(nl)),
            0,
            nl,
            static_cast<float>(across(nv) * std::cos(azimuth)),
            static_cast<float>(across(nv) * std::sin(azimuth)),
            nv,
            m,
            lobe,
            ior,
            ior,
            ior};
}

} // namespace lightbench::kernels
