// What both ways of blending share: the tables of a tile's layers, and the sum from the front to the back.
#include "shared/layouts.h"
#include "fetch.glsl"
#include "raster/layers.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { LayersPush push; };
layout(set = 0, binding = 0, rgba32f) uniform image2D radiance;
layout(set = 0, binding = 1, scalar) readonly buffer Cursors { uint cursors[]; };
FETCH_TABLE(counts, FETCH_LAYERS, 2)
FETCH_TABLE(blocks, FETCH_LAYERS, 4)
FETCH_TABLE(layers, FETCH_LAYERS, 6)
FETCH_TABLE(layer_surfaces, FETCH_LAYERS, 14)
FETCH_TABLE(layer_opacities, FETCH_LAYERS, 16)
FETCH_TABLE(materials, FETCH_MATERIALS, 18)

layout(constant_id = CONSTANT_EFFECTS) const uint kEffects = 0u;

uint invocation() { return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }

// A pixel of the tile and its list.
struct List {
    uvec2 at;   // pixels from the tile's corner
    uint n;     // layers
    uvec4 block;
};

List list_of(uint i) {
    uvec2 at = uvec2(i % push.size.x, i / push.size.x);
    uint counted = tile_pixel(at + push.origin - push.counted_origin, push.counted_width);
    return List(at, fetch_counts(counted >> 2u)[counted & 3u], fetch_blocks(block_at(at, push.size.x)));
}

uint record_of(List list, uint place) { return record_of(list.block, place, list.at); }

vec3 opacity_of(uint record) {
    if ((kEffects & EFFECT_TEXTURE_ALPHA) != 0u) return uintBitsToFloat(fetch_layer_opacities(record).xyz);
    uint surface = 0u;
    if ((kEffects & EFFECT_MANY_MATERIALS) != 0u) surface = fetch_layer_surfaces(record >> 2u)[record & 3u];
    return uintBitsToFloat(fetch_materials(kMaterialTexels * surface + kMaterialOpacity).xyz);
}

// A key: (bits of the depth, record). Reversed depth is positive: the nearer has the larger bits.
uvec2 key_of(uint record) { return uvec2(fetch_layers(record).x, record); }

bool less(uvec3 a, uvec3 b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

// Coincident fragments are ordered by the bits of opacity and radiance, never by who drew first (TR-4).
bool looks_before(uint a, uint b) {
    uvec3 ta = floatBitsToUint(opacity_of(a)), tb = floatBitsToUint(opacity_of(b));
    return ta != tb ? less(ta, tb) : less(fetch_layers(a).yzw, fetch_layers(b).yzw);
}

// S13: I = t If + (1 - t) Ib, unrolled from the front: what is in front lets `through` of the rest pass (TR-3). A factor of 0 is not
// multiplied, so that what nobody sees may be infinite (TR-1).
struct Blend {
    vec3 sum, through;
};
vec3 weighed(vec3 weight, vec3 radiance_) { return mix(weight * radiance_, vec3(0.0), equal(weight, vec3(0.0))); }

void blend_layer(inout Blend b, uint record) {
    vec3 t = opacity_of(record);
    b.sum += weighed(b.through * t, uintBitsToFloat(fetch_layers(record).yzw));
    b.through *= 1.0 - t;
}

// Over the opaque radiance. A pixel whose fragments were not all listed as they were counted becomes NaN, which the census reports.
void finish(List list, Blend b) {
    ivec2 at = ivec2(push.origin + list.at);
    vec3 behind = imageLoad(radiance, at).rgb;
    vec3 all = b.sum + weighed(b.through, behind);
    if (cursors[tile_pixel(list.at, push.size.x)] != list.n) all = vec3(uintBitsToFloat(0x7fc00000u));
    imageStore(radiance, at, vec4(all, 1.0));
}
