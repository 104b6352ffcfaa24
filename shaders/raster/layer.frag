// Fragment stage of translucent surfaces: shades like any other, and puts the record into its pixel's run.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "raster/surface.glsl"
#include "raster/layers.glsl"

layout(early_fragment_tests) in;
layout(set = 0, binding = 18, scalar) buffer Cursors { uint cursors[]; }; // how many records each pixel has so far
layout(set = 0, binding = 19, scalar) writeonly buffer Layers { uvec4 layers[]; };
layout(set = 0, binding = 22, scalar) writeonly buffer Surfaces { uint surfaces[]; };
layout(set = 0, binding = 23, scalar) writeonly buffer Opacities { vec4 opacities[]; };
FETCH_TABLE(blocks, FETCH_LAYERS, 20)

void main() {
    uvec2 at = uvec2(gl_FragCoord.xy) - uvec2(push.list_origin & 0xffffu, push.list_origin >> 16u);
    Fragment f = surface_fragment();
    uvec4 block = fetch_blocks(block_at(at, push.list_width));
    uint place = atomicAdd(cursors[tile_pixel(at, push.list_width)], 1u);
    if (place < block.y) { // one that was not counted may stay out, and is found out when the pixel is blended
        uint record = record_of(block, place, at);
        layers[record] = uvec4(floatBitsToUint(gl_FragCoord.z), floatBitsToUint(f.radiance));
        if (wants(EFFECT_TEXTURE_ALPHA)) opacities[record] = vec4(f.opacity, 0.0);
        else if (wants(EFFECT_MANY_MATERIALS)) surfaces[record] = material;
    }
}
