// Fragment stage of translucent surfaces: shades like any other, and puts the record into its pixel's run.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "raster/surface.glsl"
#include "raster/layers.glsl"

layout(early_fragment_tests) in;
layout(set = 0, binding = 18, scalar) buffer Counts { uint counts[]; };
layout(set = 0, binding = 19, scalar) writeonly buffer Layers { uvec4 layers[]; };
FETCH_TABLE(offsets, FETCH_LAYERS, 20)

uint offset_of(uint i) { return fetch_offsets(i >> 2u)[i & 3u]; }

void main() {
    uint pixel = tile_pixel(uvec2(gl_FragCoord.xy), push.list_origin, push.list_width);
    Fragment f = surface_fragment();
    uint first = offset_of(pixel), place = atomicAdd(counts[pixel], 1u);
    if (place < offset_of(pixel + 1u) - first) { // one that was not counted stays out, and is found out when the pixel is blended
        uint at = kRecordWords * (first + place);
        uvec3 t = floatBitsToUint(f.opacity);
        layers[at] = uvec4(floatBitsToUint(gl_FragCoord.z), tie_of(f.opacity, f.radiance), t.xy);
        layers[at + 1u] = uvec4(t.z, floatBitsToUint(f.radiance));
    }
}
