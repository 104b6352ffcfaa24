// Tests every primitive (S24): what the structures are compared with. In: the global ray, push.triangle_count, .sphere_count, .shape_count.
// Out: the nearest hit, or with `any` the first that is found.
#ifndef LIGHTBENCH_RAYTRACE_WALK_NONE_GLSL
#define LIGHTBENCH_RAYTRACE_WALK_NONE_GLSL

#include "raytrace/intersect.glsl"
#include "raytrace/walk.glsl"

// Put down: node is how many have been tested, triangles first, then spheres, then shapes.
bool walk_none(inout RayHit hit, bool any, inout Walk w) {
    uint spheres = push.triangle_count, shapes = spheres + push.sphere_count, all = shapes + push.shape_count;
    uint i = w.node, limit = w.node == kNothing ? 0u : min(all, w.node + kStepBudget);
    bool found = false;
    if (wants_ray(RAY_TRIANGLES))
        for (; i < min(limit, spheres) && !found; ++i) {
            test_triangle(i, hit);
            found = any && hit.ref != kNothing;
        }
    if (wants_ray(RAY_SPHERES))
        for (; i < min(limit, shapes) && !found; ++i) {
            test_sphere(i - spheres, hit);
            found = any && hit.ref != kNothing;
        }
    if (wants_ray(RAY_SHAPES))
        for (; i < limit && !found; ++i) {
            test_shape(i - shapes, hit);
            found = any && hit.ref != kNothing;
        }
    bool ended = found || i >= all;
    w.node = ended ? kNothing : i, w.top = 0u;
    return ended;
}

#endif
