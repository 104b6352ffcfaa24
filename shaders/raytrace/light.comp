// The illumination model at the points of a generation (S14, the terms that need no further ray). In: points, rays, lights, visibility.
// Out: the color of each ray's node, without its children.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#define LIGHTBENCH_TRACED
#include "raytrace/rays.glsl"
#include "raytrace/points.glsl"
#include "shade.glsl"
#include "environment.glsl"

FETCH_TABLE(lit, FETCH_RAYS, 30)
FETCH_TABLE(tree, FETCH_RAYS, 28)
layout(set = 0, binding = 34, scalar) buffer Tree { uvec4 node_words[]; };
layout(set = 0, binding = 46, scalar) buffer Carries { vec4 carries[]; }; // of the sum over pieces of the lights (LI-6)

uint point_index = 0u;

vec3 visibility(uint light) {
    if (!wants_ray(RAY_SHADOWS)) return vec3(1.0);
    vec3 lit = uintBitsToFloat(fetch_lit(light * push.count + point_index).xyz);
    return kOutput == OUTPUT_SHADOW ? 1.0 - lit : lit;
}

// Where no ray is sent after the mirror image the environment stands in for it, as in the rasteriser (S12).
vec3 mirrored(Surface s, Material m) {
    if (!wants(EFFECT_MIRROR_ENVIRONMENT)) return vec3(0.0);
    return mirror_factor(s, m) * environment_radiance(reflected(s.normal, s.to_viewer), 0.0);
}

void main() {
    uint i = invocation();
    count_done(push.count);
    if (i >= push.count) return;
    point_index = i;
    RayPoint p = read_point(i);
    uint from = ray_of_hit(i);
    Material m = read_material(p.surface);
    if (wants(EFFECT_ANY_TEXTURE)) m.diffuse = p.diffuse;
    Surface s = Surface(p.position, p.normal, -uintBitsToFloat(fetch_rays(kRayTexels * from + 1u).xyz));
    bool first = push.first_light == 0u;
    vec3 color = vec3(0.0);
    if (first) color = shade(s, m) + mirrored(s, m);
    else if (wants(EFFECT_POINT_LIGHT | EFFECT_DIRECTIONAL_LIGHT | EFFECT_SPOT_LIGHT)) color = sum_lights(s, m, kPartAll);
    if (wants(EFFECT_TRANSPARENCY)) color *= p.opacity;
    uint at = kRayNodeTexels * (push.first + from);
    Sum3 sum = sum_start();
    if (push.more != 0u) sum.total = uintBitsToFloat(fetch_tree(at).xyz);
    if (wants_ray(RAY_SHADOWS) && wants(EFFECT_COMPENSATED_SUM)) {
        if (push.more != 0u) sum.carry = carries[i].xyz;
        sum_add(sum, color);
        carries[i] = vec4(sum.carry, 0.0);
    } else sum.total += color;
    node_words[at] = uvec4(floatBitsToUint(sum.total), p.children);
}
