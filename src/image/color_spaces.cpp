// Matrices and curves, each with its source.
#include "image/color_spaces.h"

#include <cmath>

namespace lightbench::color {

// IEC 61966-2-1:1999: primaries (0.64, 0.33) (0.30, 0.60) (0.15, 0.06), white (0.3127, 0.3290), each row divided by its sum,
// the white point, so that white is (1, 1, 1).
Triple xyz_from_linear(const Triple& rgb) {
    return {0.433887346f * rgb.x + 0.376224009f * rgb.y + 0.189888645f * rgb.z,
            0.212639006f * rgb.x + 0.715168679f * rgb.y + 0.072192315f * rgb.z,
            0.017750040f * rgb.x + 0.109447621f * rgb.y + 0.872802339f * rgb.z};
}

Triple linear_from_xyz(const Triple& xyz) {
    return {3.080399091f * xyz.x - 1.537383178f * xyz.y - 0.543015913f * xyz.z,
            -0.921223359f * xyz.x + 1.875967502f * xyz.y + 0.045255857f * xyz.z,
            0.052873939f * xyz.x - 0.203976959f * xyz.y + 1.151103020f * xyz.z};
}

// Andersson et al. 2020, section 4.1: linearised CIELAB.
Triple ycxcz_from_xyz(const Triple& xyz) {
    return {116.0f * xyz.y - 16.0f, 500.0f * (xyz.x - xyz.y), 200.0f * (xyz.y - xyz.z)};
}

Triple xyz_from_ycxcz(const Triple& opponent) {
    float y = (opponent.x + 16.0f) / 116.0f;
    return {y + opponent.y / 500.0f, y, y - opponent.z / 200.0f};
}

// CIE 15:2004, 8.2.1.
Triple lab_from_xyz(const Triple& xyz) {
    auto f = [](float t) {
        constexpr float kDelta = 6.0f / 29.0f;
        return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
    };
    float fx = f(xyz.x), fy = f(xyz.y), fz = f(xyz.z);
    return {116.0f * fy - 16.0f, 500.0f * (fx - fy), 200.0f * (fy - fz)};
}

} // namespace lightbench::color
