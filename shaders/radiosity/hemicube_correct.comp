// Form factors to elements that are near: analytic from points of the element to the patch (Baum, Rushmeier, Winget 1989), by reciprocity,
// times the part of it that rays find visible. One SIMD group an element: its lanes share the patch's elements and the rays.
// In: the list of near elements, the structure of rays. Out: their entries of the rows.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define LIGHTBENCH_ANY_HIT true
#include "raytrace/walks.glsl"
#include "radiosity/hemicube_view.glsl"
#include "radiosity/receivers.glsl"
#include "lib/form_factor.glsl"
#include "shared/solve.h"

layout(constant_id = CONSTANT_NEAR_RAYS) const uint kNearRays = 16u;
layout(constant_id = CONSTANT_SHARES) const uint kShares = 0u; // 1: there is a table of what elements have to shoot
FETCH_TABLE(unshot, FETCH_UNSHOT, 64)
FETCH_TABLE(element_corners, FETCH_ELEMENT_CORNERS, 60)
layout(set = 0, binding = 56, scalar) buffer Rows { uint rows[]; };
layout(set = 0, binding = 62, scalar) readonly buffer NearCount { uint near_count; };
layout(set = 0, binding = 63, scalar) readonly buffer NearList { uint near_list[]; };

struct Quad {
    vec3 q[4]; // frame
};

Quad read_quad(uint element) {
    uint at = kElementCornerTexels * element;
    return Quad(vec3[4](uintBitsToFloat(fetch_element_corners(at).xyz), uintBitsToFloat(fetch_element_corners(at + 1u).xyz),
                        uintBitsToFloat(fetch_element_corners(at + 2u).xyz), uintBitsToFloat(fetch_element_corners(at + 3u).xyz)));
}

float size_of(vec3 v) { return abs(v.x) + abs(v.y) + abs(v.z); }

// A point of the element by Gauss' rule, two by two of them, and its weight: the centre alone is off by 1.7 % for elements as large as half
// their distance.
vec3 gauss_point(Quad k, uint i, out float weight) {
    vec2 at = vec2((i & 1u) == 0u ? 0.21132487 : 0.7886751, (i & 2u) == 0u ? 0.21132487 : 0.7886751);
    vec3 low = mix(k.q[0], k.q[1], at.x), high = mix(k.q[3], k.q[2], at.x);
    weight = length(cross(mix(k.q[1] - k.q[0], k.q[2] - k.q[3], at.y), high - low));
    return mix(low, high, at.y);
}

// What an element sends, by area: what it has to shoot, all channels together. A patch is not as bright everywhere: where a shadow falls on it
// is seen by what is near. Without that all is alike, but for what lies under something else.
float sent_by(uint element) {
    if (kShares == 0u) return read_receiver(element).covered == 0u ? 1.0 : 0.0;
    uint at = kSolveStateTexels * element;
    return uintBitsToFloat(fetch_unshot(at).w) + uintBitsToFloat(fetch_unshot(at + 1u).w) + uintBitsToFloat(fetch_unshot(at + 2u).w);
}

// From a point of the receiver to one of the patch's elements. A height is off by gamma(6) of what it is made of, and both points by u:
// within 16 u one lies in the plane of the other, and sees nothing of it (HC-10).
float to_element(vec3 p, vec3 n, uint element) {
    Quad k = read_quad(element);
    vec3 normal = read_receiver(element).normal;
    vec3 a = k.q[0] - p, b = k.q[1] - p, c = k.q[2] - p, d = k.q[3] - p;
    float least = gamma(16.0) * (size_of(p) + max(max(size_of(a), size_of(b)), max(size_of(c), size_of(d))));
    float f = point_to_quad(n, a, b, c, d, least);
    // Before all of its corners: of one that is not quite flat, the other side lies before some.
    float height = -max(max(dot(normal, a), dot(normal, b)), max(dot(normal, c), dot(normal, d)));
    return height > least ? f : 0.0;
}

// The s-th point of the patch as seen from the receiver: a ray to it, of length 1, and what it weighs in the integral. Points lie in all
// elements in turn, in each as the plastic number's sequence has them (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
float aim(HemicubeView v, Receiver r, uint s, out vec3 way) {
    bool many = v.count >= kNearRays;
    uint m = many ? s * v.count / kNearRays : s % v.count, round = many ? s : s / v.count;
    vec2 at = fract(0.5 + vec2(0.7548777, 0.5698403) * float(round));
    Quad k = read_quad(v.first + m);
    vec3 normal = read_receiver(v.first + m).normal;
    // On the two triangles that rays are tested against: a quadrilateral that is not quite flat lies before or behind them.
    bool first = at.x >= at.y;
    vec3 along = first ? k.q[1] - k.q[0] : k.q[2] - k.q[3], up = first ? k.q[2] - k.q[1] : k.q[3] - k.q[0];
    vec3 p = k.q[0] + at.x * along + at.y * up;
    vec3 reach = max(max(abs(k.q[0] - p), abs(k.q[1] - p)), max(abs(k.q[2] - p), abs(k.q[3] - p)));
    vec3 error = gamma(8.0) * (abs(p) + reach) + gamma(6.0) * max(reach.x, max(reach.y, reach.z)); // as above_surface() has it
    way = offset_origin(p, error, normal, normal) - r.center;
    float square = max(dot(way, way), 1.17549435e-38);
    return max(dot(way, r.normal), 0.0) * max(-dot(way, normal), 0.0) * sent_by(v.first + m) * length(cross(along, up)) /
           (square * square);
}

// True if all walks came to an end. In: the receiver. Out: weight of what rays reach, and of all they were sent to.
bool look(HemicubeView v, Receiver r, out float seen, out float sent) {
    bool all_done = true;
    uint first = 0u;
    seen = 0.0, sent = 0.0;
    for (; first < kNearRays; first += gl_SubgroupSize) {
        uint s = first + gl_SubgroupInvocationID;
        vec3 way;
        float weight = aim(v, r, min(s, kNearRays - 1u), way);
        bool asked = s < kNearRays && weight > 0.0;
        start_ray(Ray(r.center, 0.0, asked ? way : r.normal, kNothing, 0.0, 0u, 0.0, 0u));
        RayHit hit = RayHit(asked ? 0.99999905 : -1.0, kNothing, 0.0, 0.0); // ends before the patch by 16 u, as shadow rays do (SH-3)
        Walk w = walk_start(asked);
        all_done = walk(hit, true, w) && all_done;
        sent += asked ? weight : 0.0;
        seen += asked && hit.ref == kNothing ? weight : 0.0;
    }
    seen = subgroupAdd(seen), sent = subgroupAdd(sent);
    return all_done && first >= kNearRays;
}

// Invocations of a SIMD group take the list's entries together, and go on with the next share of it. Rows keep what the hemi-cube found
// where no ray could be sent.
void main() {
    count_done(push.count);
    const uint elements = push.first;
    uint listed = near_count, groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y * gl_NumSubgroups;
    uint at = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_NumSubgroups + gl_SubgroupID;
    bool done = true;
    for (; at < listed; at += groups) {
        uint entry = near_list[at], cube = entry / elements, element = entry - cube * elements;
        HemicubeView v = read_view(cube);
        Receiver r = read_receiver(element);
        Quad own = read_quad(element);
        // F(patch -> element) = A sum of F(element -> e) dB_e over sum of A_e dB_e, by reciprocity.
        float sum = 0.0, weights = 0.0, energy = 0.0, weight, seen, sent;
        uint m = gl_SubgroupInvocationID;
        for (; m < 4u * v.count; m += gl_SubgroupSize) {
            uint e = v.first + (m >> 2u);
            vec3 p = gauss_point(own, m & 3u, weight);
            float share = sent_by(e);
            sum += weight * share * to_element(p, r.normal, e), weights += weight, energy += 0.25 * share * read_receiver(e).area;
        }
        done = look(v, r, seen, sent) && m >= 4u * v.count && done;
        float mean = subgroupAdd(sum) / max(subgroupAdd(weights), 1.17549435e-38) * float(v.count); // over points, summed over elements
        float factor = min(mean * r.area / max(subgroupAdd(energy), 1.17549435e-38), 1.0) * min(seen / max(sent, 1.17549435e-38), 1.0);
        if (subgroupElect() && sent > 0.0) rows[entry] = uint(factor * 2147483648.0 + 0.5);
    }
    count_unfinished(done && at >= listed);
}
