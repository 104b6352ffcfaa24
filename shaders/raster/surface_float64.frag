// Fragment stage of opaque surfaces with --precision float64: Phong's terms are evaluated in double from what is interpolated in float.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#define LIGHTBENCH_FLOAT64
#include "raster/surface.glsl"

layout(location = 0) out vec4 color;

void main() { color = vec4(surface_fragment().radiance, 1.0); }
