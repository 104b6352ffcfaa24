// What both ways of blending share: the tables of a tile's layers, and the sum from the front to the back.
#include "shared/layouts.h"
#include "fetch.glsl"
#include "raster/layers.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { LayersPush push; };
layout(set = 0, binding = 0, rgba32f) uniform image2D radiance;
layout(set = 0, binding = 1, scalar) readonly buffer Counts { uint counts[]; };
FETCH_TABLE(offsets, FETCH_LAYERS, 2)
FETCH_TABLE(layers, FETCH_LAYERS, 4)

uint offset_of(uint i) { return fetch_offsets(i >> 2u)[i & 3u]; }

uint invocation() { return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }

ivec2 pixel_at(uint i) { return ivec2(push.origin + uvec2(i % push.size.x, i / push.size.x)); }

// S13: I = t If + (1 - t) Ib, unrolled from the front: what is in front lets `through` of the rest pass (TR-3). A factor of 0 is not
// multiplied, so that what nobody sees may be infinite (TR-1).
struct Blend {
    vec3 sum, through;
};
vec3 weighed(vec3 weight, vec3 radiance_) { return mix(weight * radiance_, vec3(0.0), equal(weight, vec3(0.0))); }

void blend_layer(inout Blend b, uint record) {
    uvec4 k = fetch_layers(kRecordWords * record), c = fetch_layers(kRecordWords * record + 1u);
    vec3 t = uintBitsToFloat(uvec3(k.zw, c.x));
    b.sum += weighed(b.through * t, uintBitsToFloat(c.yzw));
    b.through *= 1.0 - t;
}

// Over the opaque radiance. A pixel whose fragments were not all listed as they were counted becomes NaN, which the census reports.
void finish(uint i, Blend b, uint n) {
    ivec2 at = pixel_at(i);
    vec3 behind = imageLoad(radiance, at).rgb;
    vec3 all = b.sum + weighed(b.through, behind);
    if (counts[i] != n) all = vec3(uintBitsToFloat(0x7fc00000u));
    imageStore(radiance, at, vec4(all, 1.0));
}
