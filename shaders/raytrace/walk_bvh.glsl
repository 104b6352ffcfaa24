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

layout(constant_id = CONSTANT_LOOSE) const uint kLoose = 0u;
#define in_tree(type) ((kLoose >> (12u + (type)) & 1u) != 0u)
#define loose(type) (kLoose >> (4u * (type)) & 15u)

// What is in no tree, since there are too few of its type.
void test_loose(inout RayHit hit) {
    if (loose(kTypeTriangle) > 0u)
        for (uint i = 0u; i < loose(kTypeTriangle); ++i) test_triangle(i, hit);
    if (loose(kTypeSphere) > 0u)
        for (uint i = 0u; i < loose(kTypeSphere); ++i) test_sphere(i, hit);
    if (loose(kTypeShape) > 0u)
        for (uint i = 0u; i < loose(kTypeShape); ++i) test_shape(i, hit);
}

bool is_leaf(uint ref) { return (ref & kRefLeaf) != 0u; } // kNothing is one

// The primitives of a leaf. A lane without one has kNothing.
void test_leaf(uint ref, inout RayHit hit) {
    uint count = ref == kNothing ? 0u : ((ref >> kRefCount) & 3u) + 1u, type = type_of(ref), first = index_of(ref);
    if (in_tree(kTypeTriangle))
        for (uint i = 0u; i < (type == kTypeTriangle ? count : 0u); ++i) test_triangle(first + i, hit);
    if (in_tree(kTypeSphere))
        for (uint i = 0u; i < (type == kTypeSphere ? count : 0u); ++i) test_sphere(first + i, hit);
    if (in_tree(kTypeShape))
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
    if (push.resume == 0u) test_loose(hit);
    at = any && hit.ref != kNothing ? kNothing : at;
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

// Bits that any of the eight rays has set. Shuffles cost a third of what votes and reductions do on CPU drivers.
uint packet_or(uint bits) {
    bits |= subgroupShuffleXor(bits, 1u);
    bits |= subgroupShuffleXor(bits, 2u);
    return bits | subgroupShuffleXor(bits, 4u);
}

// Planes of the four boxes, those first that the ray meets first.
struct WideNode {
    vec4 near_x, far_x, near_y, far_y, near_z, far_z;
    uvec4 children;
};

// `first`: of the two planes along each axis, the texel of the one that this ray meets first. Chosen as they are dealt out, they need no min
// and max later.
WideNode read_wide(uint index, uvec3 first) {
    uvec4 q = fetch_nodes(kWideTexels * index + gl_SubgroupInvocationID);
    return WideNode(uintBitsToFloat(subgroupShuffle(q, first.x)), uintBitsToFloat(subgroupShuffle(q, first.x ^ 1u)),
                    uintBitsToFloat(subgroupShuffle(q, first.y)), uintBitsToFloat(subgroupShuffle(q, first.y ^ 1u)),
                    uintBitsToFloat(subgroupShuffle(q, first.z)), uintBitsToFloat(subgroupShuffle(q, first.z ^ 1u)), subgroupShuffle(q, 6u));
}

// Which of the four boxes the ray enters.
uint enter_wide(WideNode n, vec3 near, vec3 far, vec3 inv_d, float limit) {
    vec4 t_in = max(max((n.near_x - near.x) * inv_d.x, (n.near_y - near.y) * inv_d.y), max((n.near_z - near.z) * inv_d.z, vec4(0.0)));
    vec4 t_out = min(min((n.far_x - far.x) * inv_d.x, (n.far_y - far.y) * inv_d.y), min((n.far_z - far.z) * inv_d.z, vec4(limit)));
    t_out *= 1.00000095; // 2^-20: see enter_narrow
    bvec4 enters = lessThanEqual(t_in, t_out);
    return uint(enters.x) | uint(enters.y) << 1u | uint(enters.z) << 2u | uint(enters.w) << 3u;
}

#define NEARER_FIRST(I, J)                                        \
    {                                                             \
        bool swap = t[J] < t[I];                                  \
        float t_low = swap ? t[J] : t[I], t_high = swap ? t[I] : t[J]; \
        uint low = swap ? child[J] : child[I], high = swap ? child[I] : child[J]; \
        t[I] = t_low, t[J] = t_high, child[I] = low, child[J] = high; \
    }

// The stack of a packet lies across its lanes, entry i in lane i & 7 of row i >> 3: an array that each lane keeps for itself is written lane by
// lane on CPU drivers, and took a fifth of the walk.
const uint kRows = (kStack + 7u) / 8u;
uint stack_rows[kRows];

void push_row(uint at, uint value) {
    for (uint r = 0u; r < kRows; ++r) stack_rows[r] = at == 8u * r + gl_SubgroupInvocationID ? value : stack_rows[r];
}

uint read_row(uint at) {
    uint row = stack_rows[0];
    for (uint r = 1u; r < kRows; ++r) row = at >= 8u * r ? stack_rows[r] : row;
    return subgroupShuffle(row, at & 7u);
}

// All eight go wherever one of them must: what they find is what each would find alone. The nearer child first, by where its middle lies
// along the first ray, which all of them can tell; the farther ones wait.
bool walk_wide(inout RayHit hit, bool any, inout Walk w) {
    bvec3 back = lessThan(ray.inv_d, vec3(0.0));
    uvec3 first = uvec3(0u, 2u, 4u) + uvec3(back);
    vec3 slack = mix(vec3(ray.slack), vec3(-ray.slack), back), near = ray.o + slack, far = ray.o - slack, along = subgroupShuffle(ray.d, 0u);
    uint at = w.node, top = w.top, steps = 0u;
    for (uint r = 0u; r < kRows; ++r) stack_rows[r] = kNothing;
    if (push.resume == 0u) test_loose(hit);
    while (at != kNothing && steps < kPacketBudget) {
        while (!is_leaf(at)) {
            WideNode n = read_wide(at, first);
            float limit = any && hit.ref != kNothing ? -1.0 : hit.t;
            uint entered = packet_or(enter_wide(n, near, far, ray.inv_d, limit));
            uvec4 child = n.children;
            ++steps;
            if (any) { // the order does not matter, and sorting is a third of a node's work
                push_row(top, child.w);
                top += uint((entered & 8u) != 0u && child.w != kNothing);
                push_row(top, child.z);
                top += uint((entered & 4u) != 0u && child.z != kNothing);
                push_row(top, child.y);
                top += uint((entered & 2u) != 0u && child.y != kNothing);
                push_row(top, child.x);
                top += uint((entered & 1u) != 0u && child.x != kNothing);
                --top;
                at = read_row(top);
                continue;
            }
            vec4 t = (n.near_x + n.far_x) * along.x + (n.near_y + n.far_y) * along.y + (n.near_z + n.far_z) * along.z;
            t = mix(vec4(kNoHit), t, notEqual(uvec4(entered) & uvec4(1u, 2u, 4u, 8u), uvec4(0u)));
            t = mix(t, vec4(kNoHit), equal(child, uvec4(kNothing))); // which rays of NaN enter
            NEARER_FIRST(0, 1) NEARER_FIRST(2, 3) NEARER_FIRST(0, 2) NEARER_FIRST(1, 3) NEARER_FIRST(1, 2)
            push_row(top, child.w);
            top += uint(t.w < kNoHit);
            push_row(top, child.z);
            top += uint(t.z < kNoHit);
            push_row(top, child.y);
            top += uint(t.y < kNoHit);
            bool none = t.x == kNoHit;
            top -= uint(none);
            uint popped = read_row(top);
            at = none ? popped : child.x;
        }
        while (is_leaf(at) && at != kNothing) {
            test_leaf(at, hit);
            --top;
            at = read_row(top);
            if (any && packet_or(uint(hit.ref == kNothing && hit.t > 0.0)) == 0u) at = kNothing; // all have found something
            steps += 4u;
        }
    }
    w.node = at, w.top = top;
    return at == kNothing;
}

#endif
