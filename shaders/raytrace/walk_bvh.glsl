// Walks through the tree of boxes: each ray by itself through the narrow tree, or eight rays together through the wide one. Aila and Laine
// 2009, "Understanding the Efficiency of Ray Traversal on GPUs" (the loops); Wald, Slusallek, Benthin and Wagner 2001, "Interactive Rendering
// with Coherent Ray Tracing" (packets). In: the global ray. Out: the nearest hit, or with `any` the first that is found.
#ifndef LIGHTBENCH_RAYTRACE_WALK_BVH_GLSL
#define LIGHTBENCH_RAYTRACE_WALK_BVH_GLSL

#include "raytrace/intersect.glsl"
#include "raytrace/walk.glsl"
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_shuffle : require

FETCH_TABLE(narrow, FETCH_NARROW, 6)

bool is_leaf(uint ref) { return (ref & kRefLeaf) != 0u; } // kNothing is one

// The primitives of a leaf. A lane without one has kNothing.
void test_leaf(uint ref, inout RayHit hit) {
    uint count = ref == kNothing ? 0u : ((ref >> kRefCount) & 3u) + 1u, type = type_of(ref), first = index_of(ref);
    if (wants_ray(RAY_TRIANGLES))
        for (uint i = 0u; i < (type == kTypeTriangle ? count : 0u); ++i) test_triangle(first + i, hit);
    if (wants_ray(RAY_SPHERES))
        for (uint i = 0u; i < (type == kTypeSphere ? count : 0u); ++i) test_sphere(first + i, hit);
    if (wants_ray(RAY_SHAPES))
        for (uint i = 0u; i < (type == kTypeShape ? count : 0u); ++i) test_shape(first + i, hit);
}

// The ray among the planes of the narrow tree, which are whole numbers.
struct NarrowRay {
    vec3 low, high; // its origin, moved by what it may be wrong by, so that lower planes come out earlier and higher ones later
    vec3 inv_d;
};

NarrowRay narrow_ray() {
    vec3 origin = uintBitsToFloat(fetch_narrow(0u).xyz), step = uintBitsToFloat(fetch_narrow(1u).xyz);
    vec3 o = (ray.o - origin) / step;
    vec3 error = vec3(ray.slack) / step + 2.9802322e-7 * (abs(o) + 65536.0); // 5 u: of the division, and of subtracting planes
    return NarrowRay(o + error, o - error, ray.inv_d * step);
}

// Where the ray enters a child, or kNoHit. The relative error of a distance is 6 u: 2^-20 is ample.
float enter_narrow(NarrowRay r, uvec4 child, float limit) {
    vec3 a = (vec3(child.xyz & 0xffffu) - r.low) * r.inv_d, b = (vec3(child.xyz >> 16u) - r.high) * r.inv_d;
    vec3 near = min(a, b), far = max(a, b);
    float t_in = max(max(near.x, near.y), max(near.z, 0.0)), t_out = min(min(far.x, far.y), min(far.z, limit)) * 1.00000095;
    return t_in <= t_out && child.w != kNothing ? t_in : kNoHit;
}

// stack[0] is kNothing: popping it ends the walk.
bool walk_narrow(inout RayHit hit, bool any, inout Walk w) {
    NarrowRay r = narrow_ray();
    uint at = w.node, top = w.top, steps = 0u;
    stack[0] = kNothing;
    while (at != kNothing && steps < kStepBudget) {
        while (!is_leaf(at)) {
            uvec4 a = fetch_narrow(kNarrowTexels * at + 2u), b = fetch_narrow(kNarrowTexels * at + 3u);
            float ta = enter_narrow(r, a, hit.t), tb = enter_narrow(r, b, hit.t);
            bool in_a = ta < kNoHit, in_b = tb < kNoHit, swap = tb < ta;
            stack[top] = swap ? a.w : b.w; // the farther child; kept if both are entered
            top += uint(in_a && in_b);
            bool none = !in_a && !in_b;
            top -= uint(none);
            at = swap ? b.w : a.w;
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

// Of the eight rays of a packet. Shuffles cost a third of what reductions do on CPU drivers.
float packet_min(float x) {
    x = min(x, subgroupShuffleXor(x, 1u));
    x = min(x, subgroupShuffleXor(x, 2u));
    return min(x, subgroupShuffleXor(x, 4u));
}

// Where the ray enters each of four boxes, or kNoHit: `planes` as the wide node holds them.
struct WideNode {
    vec4 low_x, high_x, low_y, high_y, low_z, high_z;
    uvec4 children;
};

WideNode read_wide(uint index) {
    uint at = kWideTexels * index;
    return WideNode(uintBitsToFloat(fetch_nodes(at)), uintBitsToFloat(fetch_nodes(at + 1u)), uintBitsToFloat(fetch_nodes(at + 2u)),
                    uintBitsToFloat(fetch_nodes(at + 3u)), uintBitsToFloat(fetch_nodes(at + 4u)), uintBitsToFloat(fetch_nodes(at + 5u)),
                    fetch_nodes(at + 6u));
}

vec4 enter_wide(WideNode n, vec3 low, vec3 high, vec3 inv_d, float limit) {
    vec4 ax = (n.low_x - low.x) * inv_d.x, bx = (n.high_x - high.x) * inv_d.x;
    vec4 ay = (n.low_y - low.y) * inv_d.y, by = (n.high_y - high.y) * inv_d.y;
    vec4 az = (n.low_z - low.z) * inv_d.z, bz = (n.high_z - high.z) * inv_d.z;
    vec4 t_in = max(max(min(ax, bx), min(ay, by)), max(min(az, bz), vec4(0.0)));
    vec4 t_out = min(min(max(ax, bx), max(ay, by)), min(max(az, bz), vec4(limit))) * 1.00000095; // 2^-20: see enter_narrow
    t_in = mix(vec4(kNoHit), t_in, lessThanEqual(t_in, t_out));
    return mix(t_in, vec4(kNoHit), equal(n.children, uvec4(kNothing)));
}

#define NEARER_FIRST(I, J)                                        \
    {                                                             \
        bool swap = t[J] < t[I];                                  \
        float t_low = swap ? t[J] : t[I], t_high = swap ? t[I] : t[J]; \
        uint low = swap ? child[J] : child[I], high = swap ? child[I] : child[J]; \
        t[I] = t_low, t[J] = t_high, child[I] = low, child[J] = high; \
    }

// All eight go wherever one of them must: what they find is what each would find alone. The farther children wait, the farthest lowest.
bool walk_wide(inout RayHit hit, bool any, inout Walk w) {
    vec3 low = ray.o + ray.slack, high = ray.o - ray.slack;
    uint at = w.node, top = w.top, steps = 0u;
    stack[0] = kNothing;
    while (at != kNothing && steps < kPacketBudget) {
        while (!is_leaf(at)) {
            WideNode n = read_wide(at);
            float limit = any && hit.ref != kNothing ? -1.0 : hit.t;
            vec4 t = enter_wide(n, low, high, ray.inv_d, limit);
            uvec4 child = n.children;
            t = vec4(packet_min(t.x), packet_min(t.y), packet_min(t.z), packet_min(t.w));
            NEARER_FIRST(0, 1) NEARER_FIRST(2, 3) NEARER_FIRST(0, 2) NEARER_FIRST(1, 3) NEARER_FIRST(1, 2)
            stack[top] = child.w;
            top += uint(t.w < kNoHit);
            stack[top] = child.z;
            top += uint(t.z < kNoHit);
            stack[top] = child.y;
            top += uint(t.y < kNoHit);
            bool none = t.x == kNoHit;
            top -= uint(none);
            at = none ? stack[top] : child.x;
            ++steps;
        }
        while (is_leaf(at) && at != kNothing) {
            test_leaf(at, hit);
            --top;
            at = stack[top];
            steps += 4u;
        }
    }
    w.node = at, w.top = top;
    return at == kNothing;
}

#endif
