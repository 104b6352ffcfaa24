// Composes and takes apart translate * rotateZ * rotateY * rotateX * scale.
#include "scene/transform.h"

#include "scene/write_number.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace lightbench {
namespace {

// Sine and cosine of degrees, exact at multiples of 90: cos(pi/2) in doubles is 6e-17, and a box turned by 90 degrees would lean.
glm::dvec2 sine_cosine(double degrees) {
    int quarter = 0;
    const double rest = std::remquo(degrees, 90.0, &quarter) * (glm::pi<double>() / 180);
    const double s = std::sin(rest), c = std::cos(rest);
    switch (quarter & 3) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
    }
}

// Turns by `degrees` from axis a towards axis b.
glm::dmat4 rotation(int a, int b, double degrees) {
    const glm::dvec2 sc = sine_cosine(degrees);
    glm::dmat4 m(1);
    m[a][a] = sc.y, m[b][b] = sc.y, m[a][b] = sc.x, m[b][a] = -sc.x;
    return m;
}

// r = rotateZ * rotateY * rotateX. Where cos(y) is 0, x and z turn about the same axis: all of it is given to z.
glm::dvec3 degrees_of_rotation(const glm::dmat3& r) {
    const double cos_y = std::hypot(r[0][0], r[0][1]);
    const double y = std::atan2(-r[0][2], cos_y);
    const bool locked = cos_y < 1e-14; // what rounding leaves of 0 in a product of three rotations
    const double x = locked ? 0 : std::atan2(r[1][2], r[2][2]);
    const double z = locked ? std::atan2(-r[1][0], r[1][1]) : std::atan2(r[0][1], r[0][0]);
    return glm::dvec3(x, y, z) * (180 / glm::pi<double>());
}

constexpr double kAccuracy = 1e-13; // some four hundred roundings: three rotations there, three arc tangents back

bool same(const glm::dmat4& a, const glm::dmat4& b) {
    if (a[3] != b[3]) return false;
    for (int c = 0; c < 3; ++c) {
        if (a[c].w != 0) return false;
        if (!(glm::length(a[c] - b[c]) <= kAccuracy * glm::length(a[c]))) return false;
    }
    return true;
}

} // namespace

glm::dmat4 world_from_object(const TransformParts& p) {
    const glm::dmat4 turned = rotation(0, 1, p.rotate.z) * rotation(2, 0, p.rotate.y) * rotation(1, 2, p.rotate.x);
    return glm::translate(glm::dmat4(1), p.translate) * turned * glm::scale(glm::dmat4(1), p.scale);
}

std::optional<TransformParts> transform_parts(const glm::dmat4& m) {
    TransformParts p;
    p.translate = glm::dvec3(m[3]);
    glm::dmat3 r(m);
    for (int c = 0; c < 3; ++c) p.scale[c] = glm::length(r[c]);
    if (glm::determinant(r) < 0) p.scale.x = -p.scale.x;
    for (int c = 0; c < 3; ++c) r[c] /= p.scale[c];
    p.rotate = degrees_of_rotation(r);
    for (int c = 0; c < 3; ++c) {
        p.scale[c] = shortest_near(p.scale[c], 1e-14 * std::fabs(p.scale[c]));
        p.rotate[c] = shortest_near(p.rotate[c], 1e-12); // degrees: 2e-14 radians
    }
    if (!same(m, world_from_object(p))) return std::nullopt; // also where something is not finite
    return p;
}

} // namespace lightbench
