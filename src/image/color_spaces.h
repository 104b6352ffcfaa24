// The colour spaces of FLIP, on linear sRGB with white D65. Private to image/.
#pragma once

namespace lightbench::color {

struct Triple {
    float x = 0, y = 0, z = 0;
};

Triple xyz_from_linear(const Triple& rgb); // relative to white: (1, 1, 1) for white
Triple linear_from_xyz(const Triple& xyz); // the inverse

Triple ycxcz_from_xyz(const Triple& xyz); // opponent space that the eye's contrast sensitivity was measured in
Triple xyz_from_ycxcz(const Triple& opponent);

Triple lab_from_xyz(const Triple& xyz); // CIE 1976 L*a*b*

} // namespace lightbench::color
