// Point-to-polygon form factors against the area integral, clipped at the horizon: HC-3, HC-10.
#include "kernel_test.h"

namespace lightbench::kernels {

TEST_F(Kernel, ArcTangent) {
    expect_rows(device, "arc_tangent");
}

TEST_F(Kernel, PointToQuad) {
    expect_rows(device, "point_to_quad");
}

} // namespace lightbench::kernels
