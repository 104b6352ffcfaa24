// (n, l, v, shininess), made unit in double -> phong_specular_float64, lambert_float64
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 10
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/float64.glsl"

dvec3 unit(vec3 x) {
    dvec3 wide = dvec3(x);
    return wide / sqrt(dot(wide, wide));
}

void kernel() {
    dvec3 n = unit(argument3(0)), l = unit(argument3(3)), v = unit(argument3(6));
    result(0, float(phong_specular_float64(n, l, v, double(argument(9)))));
    result(1, float(lambert_float64(n, l)));
}
