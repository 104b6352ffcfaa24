// (d, d0, cos_angle, cos_outer, cos_inner) -> attenuation_linear_float64, attenuation_inverse_square_float64, spot_falloff_float64
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 5
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/float64.glsl"

void kernel() {
    double d = double(argument(0));
    result(0, float(attenuation_linear_float64(d, double(argument(1)))));
    result(1, float(attenuation_inverse_square_float64(d)));
    result(2, float(spot_falloff_float64(double(argument(2)), double(argument(3)), double(argument(4)))));
}
