// Fragment stage of opaque surfaces, and of everything for the outputs that know no transparency.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "raster/surface.glsl"

layout(location = 0) out vec4 color;

void main() {
    color.a = 1.0;
    if (kOutput == OUTPUT_DEPTH) {
        color.rgb = vec3(1.0 / gl_FragCoord.w);
    } else if (kOutput == OUTPUT_OBJECT) {
        color.rgb = vec3(float(object + 1u));
    } else {
        color.rgb = surface_fragment().radiance;
    }
}
