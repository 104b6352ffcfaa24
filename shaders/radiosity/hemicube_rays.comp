// Hemi-cubes by rays: one invocation a pixel, one layer of work groups a hemi-cube (S28). In: views, the elements' triangles and a tree of
// boxes over them; a triangle's surface is its element, its object the element on the other side. Out: items.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "raytrace/walks.glsl"
#include "raytrace/tile.glsl"
#include "radiosity/hemicube_view.glsl"

layout(set = 0, binding = 50, scalar) writeonly buffer Items { uint items[]; };

// The side that the ray comes from decides.
uint seen_element(RayHit hit) {
    uint at = hit.ref == kNothing ? 0u : kTriangleTexels * index_of(hit.ref);
    uvec4 a = fetch_triangles(at), b = fetch_triangles(at + 1u), c = fetch_triangles(at + 2u);
    vec3 v0 = uintBitsToFloat(a.xyz), v1 = uintBitsToFloat(b.xyz), v2 = uintBitsToFloat(c.xyz);
    uint seen = dot(ray.d, cross(v1 - v0, v2 - v0)) < 0.0 ? b.w : c.w;
    return hit.ref == kNothing ? kNoElement : seen;
}

void main() {
    uint i = invocation(), cube = gl_WorkGroupID.z;
    count_done(kItems);
    bool live = i < kItems;
    HemicubeView v = read_view(cube);
    uvec2 pixel = tile_pixel(min(i, kItems - 1u), uvec2(kResolution, 3u * kResolution));
    // SIMD groups stay whole: lanes without a patch go along with a ray that nothing can be hit by.
    bool asked = live && v.patch_number != kNoElement;
    start_ray(Ray(v.center, 0.0, pixel_direction(v, pixel), kNothing, 0.0, 0u, 0.0, 0u));
    RayHit hit = RayHit(asked ? kNoHit : -1.0, kNothing, 0.0, 0.0);
    Walk w = walk_start(asked);
    bool done = walk(hit, false, w);
    if (live) items[cube * kItems + pixel.y * kResolution + pixel.x] = seen_element(hit);
    count_unfinished(done);
}
