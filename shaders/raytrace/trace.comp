// The nearest hit of every ray of a generation. In: rays, the primitives and a structure over them. Out: hits.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "raytrace/walks.glsl"

layout(set = 0, binding = 32, scalar) writeonly buffer Hits { RayHit hits[]; };

void main() {
    uint i = invocation();
    count_done(push.count);
    // Packets stay whole: lanes without a ray go along with one that nothing can be hit by.
    bool live = i < push.count;
    if (!wants_ray(RAY_PACKETS) && !live) return;
    start_ray(read_ray(min(i, push.count - 1u)));
    RayHit hit = RayHit(live ? kNoHit : -1.0, kNothing, 0.0, 0.0);
    Walk w = walk_start();
    if (wants_ray(RAY_RESUME) && push.resume != 0u) take_up_walk(min(i, push.count - 1u), w, hit);
    bool done = walk(hit, false, w);
    if (live) {
        hits[i] = hit;
        if (wants_ray(RAY_RESUME)) put_down_walk(i, w, hit);
        count_unfinished(done);
    }
    add_counts();
}
