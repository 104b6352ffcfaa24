// Walks through the tree of spheres, each ray by itself, the nearer child first. Rubin, Whitted 1980, "A 3-dimensional representation for
// fast rendering of complex scenes" (the hierarchy). In: the global ray. Out: the nearest hit, or with `any` the first that is found.
#ifndef LIGHTBENCH_RAYTRACE_WALK_SPHERE_BVH_GLSL
#define LIGHTBENCH_RAYTRACE_WALK_SPHERE_BVH_GLSL

#include "raytrace/walk_bvh.glsl" // leaves

// Where the ray enters a sphere, 0 if it starts inside, or kNoHit if it misses, leaves it before `after`, or enters it beyond `limit`.
// The part of `to` across the ray is off by 10 u |to|: of the difference u, of b and of d not being quite unit 7 u, of b d and the second
// difference 2 u; 16 u (|x| + |y| + |z|) is more, and the squares and roots, 6 u of r, lie within the sphere's 8 u.
float enter_sphere(vec4 sphere, float limit) {
    vec3 to = sphere.xyz - ray.o;
    float b = dot(to, ray.d), error = 9.5367432e-7 * (abs(to.x) + abs(to.y) + abs(to.z)), r = sphere.w * 1.0000005 + error;
    vec3 across = to - b * ray.d;
    float left = r * r - dot(across, across), half_chord = sqrt(max(left, 0.0)) * 1.0000005 + error;
    float t_in = max(b - half_chord, 0.0), t_out = b + half_chord;
    return left >= 0.0 && sphere.w >= 0.0 && t_out >= first_after() && t_in <= limit ? t_in : kNoHit;
}

// stack[0] is kNothing: popping it ends the walk.
bool walk_sphere_bvh(inout RayHit hit, bool any, inout Walk w) {
    uint at = w.node, top = w.top, steps = 0u;
    stack[0] = kNothing;
    while (at != kNothing && steps < kStepBudget) {
        while (!is_leaf(at)) {
            uint texel = kSphereNodeTexels * at;
            float ta = enter_sphere(uintBitsToFloat(fetch_nodes(texel)), hit.t), tb = enter_sphere(uintBitsToFloat(fetch_nodes(texel + 1u)), hit.t);
            uvec2 children = fetch_nodes(texel + 2u).xy;
            bool in_a = ta < kNoHit, in_b = tb < kNoHit, swap = tb < ta;
            stack[top] = swap ? children.x : children.y; // the farther child; kept if both are entered
            top += uint(in_a && in_b);
            bool none = !in_a && !in_b;
            top -= uint(none);
            at = swap ? children.y : children.x;
            at = none ? stack[top] : at;
            ++steps;
            if (wants_ray(RAY_COUNT)) ++count_nodes;
        }
        while (is_leaf(at) && at != kNothing) {
            test_leaf(at, hit);
            bool found = any && hit.ref != kNothing;
            --top;
            at = found ? kNothing : stack[top];
            steps += 4u;
        }
    }
    w.node = at, w.top = top;
    return at == kNothing;
}

#endif
