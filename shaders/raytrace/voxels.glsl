// What walks through voxels share: the part of the ray within the voxels, lists of references, the mailbox.
#ifndef LIGHTBENCH_RAYTRACE_VOXELS_GLSL
#define LIGHTBENCH_RAYTRACE_VOXELS_GLSL

#include "raytrace/intersect.glsl"
#include "raytrace/walk.glsl"

// Equal planes, origin + k * step. Walks compute every plane from its number k, so that nothing adds up over the way (TS-4); what four
// roundings of the ray do, the lists allow for: they hold what comes near a voxel (src/accel/voxels.h).
struct VoxelSpace {
    vec3 origin, step;
    uvec3 cells;
};

// Where the ray meets planes of these numbers.
vec3 plane_distances(VoxelSpace space, uvec3 k) { return (space.origin + vec3(k) * space.step - ray.o) * ray.inv_d; }

// The voxel around the ray's point at t; where the point is outside by rounding, the nearest one.
uvec3 voxel_at(VoxelSpace space, float t) {
    vec3 k = floor((ray.o + t * ray.d - space.origin) / space.step);
    return uvec3(clamp(k, vec3(0.0), vec3(space.cells - 1u)));
}

// From where on the ray can hit anything: where it enters the voxels, or `after`. kNoHit: nowhere up to `limit`.
float enter_voxels(VoxelSpace space, float limit) {
    vec3 a = (space.origin - (ray.o + ray.slack)) * ray.inv_d;
    vec3 b = (space.origin + vec3(space.cells) * space.step - (ray.o - ray.slack)) * ray.inv_d;
    vec3 near = min(a, b), far = max(a, b);
    float t_in = max(max(near.x, near.y), max(near.z, max(first_after(), 0.0)));
    float t_out = min(min(far.x, far.y), min(far.z, limit)) * 1.00000095; // 2^-20, 6 u would do
    return t_in <= t_out ? t_in : kNoHit;
}

uint word_of(uvec4 words, uint i) { return i < 2u ? (i == 0u ? words.x : words.y) : (i == 2u ? words.z : words.w); }

// The last few primitives that were tested: one that lies in several voxels is seldom tested twice. Amanatides, Woo 1987, "A Fast Voxel
// Traversal Algorithm for Ray Tracing"; a mailbox a primitive, as there, would be a store a ray and primitive.
uvec4 mailbox = uvec4(kNothing);

// Tests the reference at `place` of the lists that begin at the texel `lists`.
void test_listed(uint lists, uint place, inout RayHit hit) {
    uint ref = word_of(fetch_nodes(lists + (place >> 2u)), place & 3u);
    bool known = any(equal(mailbox, uvec4(ref)));
    for (uint n = uint(!known); n > 0u; --n) {
        test_reference(ref, hit);
        mailbox = uvec4(ref, mailbox.xyz);
    }
}

#endif
