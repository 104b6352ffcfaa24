// The illumination model: the only place where its terms are added up (S1 to S5). Evaluated at polygon centres (flat), at vertices
// (Gouraud), at fragments (Phong). In: a point of a surface and its material. Out: the radiance that leaves it towards the viewer.
#ifndef LIGHTBENCH_SHADE_GLSL
#define LIGHTBENCH_SHADE_GLSL

#include "shared/effects.h"
#include "shared/layouts.h"
#include "fetch.glsl"
#include "lib/attenuation.glsl"
#include "lib/phong.glsl"
#include "lib/spot.glsl"
#include "lib/sum.glsl"

layout(constant_id = CONSTANT_EFFECTS) const uint kEffects = 0u;
layout(constant_id = CONSTANT_SHADING) const uint kShading = SHADING_PHONG;
layout(constant_id = CONSTANT_OUTPUT) const uint kOutput = OUTPUT_RADIANCE;
layout(constant_id = CONSTANT_LIGHT_COUNT) const uint kLightCount = 0u;

layout(push_constant, scalar) uniform Push { ShadePush push; };

FETCH_TABLE(materials, FETCH_MATERIALS, 0)
FETCH_TABLE(lights, FETCH_LIGHTS, 2)

// 2^-126: keeps 1/sqrt finite at 0, and changes nothing above.
const float kLeastNormal = 1.1754944e-38;

struct Surface {
    vec3 position;   // frame
    vec3 normal;     // unit, on the side that is seen
    vec3 to_viewer;  // unit; read only where something is specular
};

// What a light sends to a point: the direction towards it and Ip after attenuation and spot shape, before any cosine.
struct Arrival {
    vec3 l;
    vec3 intensity;
};

bool wants(uint effect) { return (kEffects & effect) != 0u; }

// True if `effect` is the only one of `family` in the mask: then nobody needs to ask a light which it is.
bool only(uint effect, uint family) { return (kEffects & family) == effect; }

// Only what a term of the mask reads is fetched; the rest is 0.
Material read_material(uint index) {
    uint at = wants(EFFECT_MANY_MATERIALS) ? 3u * index : 0u;
    uvec4 a = uvec4(0u), b = uvec4(0u), c = uvec4(0u);
    if (wants(EFFECT_AMBIENT | EFFECT_DIFFUSE | EFFECT_SPECULAR)) a = fetch_materials(at);
    if (wants(EFFECT_SPECULAR)) b = fetch_materials(at + 1u);
    if (wants(EFFECT_EMISSION)) c = fetch_materials(at + 2u);
    return Material(uintBitsToFloat(a.xyz), uintBitsToFloat(a.w), uintBitsToFloat(b.xyz), 0u, uintBitsToFloat(c.xyz), 0.0);
}

Light read_light(uint index) {
    uvec4 a = fetch_lights(4u * index), b = fetch_lights(4u * index + 1u), c = uvec4(0u), d = uvec4(0u);
    if (wants(EFFECT_SPOT_LIGHT | EFFECT_ATTENUATION_LINEAR)) c = fetch_lights(4u * index + 2u);
    if (wants(EFFECT_SPOT_LIGHT)) d = fetch_lights(4u * index + 3u);
    return Light(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.xyz), uintBitsToFloat(c.w),
                 uintBitsToFloat(d.x), uintBitsToFloat(d.y), 0.0, 0.0);
}

// Unit vector from p to the viewer; 0 where no term reads it.
vec3 direction_to_viewer(vec3 p) {
    if (!wants(EFFECT_SPECULAR)) return vec3(0.0);
    vec3 to_eye = push.eye - p;
    return to_eye * inversesqrt(max(dot(to_eye, to_eye), kLeastNormal));
}

// S4. The factor by which a positional light's Ip arrives at distance d.
float attenuation(Light light, float d) {
    const uint laws = EFFECT_ATTENUATION_NONE | EFFECT_ATTENUATION_LINEAR | EFFECT_ATTENUATION_INVERSE_SQUARE;
    if (only(EFFECT_ATTENUATION_LINEAR, laws)) return attenuation_linear(d, light.d0);
    if (only(EFFECT_ATTENUATION_INVERSE_SQUARE, laws)) return attenuation_inverse_square(d);
    float factor = 1.0;
    if (wants(EFFECT_ATTENUATION_LINEAR) && light.attenuation == kAttenuationLinear) factor = attenuation_linear(d, light.d0);
    if (wants(EFFECT_ATTENUATION_INVERSE_SQUARE) && light.attenuation == kAttenuationInverseSquare) factor = attenuation_inverse_square(d);
    return factor;
}

Arrival arrive_positional(Light light, vec3 p) {
    vec3 to_light = light.position - p;
    float d2 = max(dot(to_light, to_light), kLeastNormal); // a light at the point itself has L = 0: its terms vanish (LI-5)
    float inverse = inversesqrt(d2);
    Arrival a = Arrival(to_light * inverse, light.intensity * attenuation(light, d2 * inverse));
    const uint types = EFFECT_POINT_LIGHT | EFFECT_SPOT_LIGHT;
    if (wants(EFFECT_SPOT_LIGHT)) {
        float shape = spot_falloff(-dot(a.l, light.axis), light.cos_outer, light.cos_inner);
        a.intensity *= only(EFFECT_SPOT_LIGHT, types) || light.type == kLightSpot ? shape : 1.0;
    }
    return a;
}

Arrival arrive(Light light, vec3 p) {
    const uint types = EFFECT_POINT_LIGHT | EFFECT_SPOT_LIGHT | EFFECT_DIRECTIONAL_LIGHT;
    if (only(EFFECT_DIRECTIONAL_LIGHT, types)) return Arrival(light.position, light.intensity);
    if (!wants(EFFECT_DIRECTIONAL_LIGHT)) return arrive_positional(light, p);
    if (light.type == kLightDirectional) return Arrival(light.position, light.intensity);
    return arrive_positional(light, p);
}

// The terms of one light.
vec3 reflect_light(Surface s, Material m, Arrival a) {
    if (kOutput == OUTPUT_ATTENUATION) return a.intensity;
    vec3 factor = vec3(0.0);
    if (wants(EFFECT_DIFFUSE)) factor += m.diffuse * lambert(s.normal, a.l);                                     // S2
    if (wants(EFFECT_SPECULAR)) factor += m.specular * phong_specular(s.normal, a.l, s.to_viewer, m.shininess);  // S3
    return factor * a.intensity;
}

// S5. All lights of this pass. A driver that ends loops early without a word (lavapipe: 65 535 iterations for eight invocations)
// is found out by the count: the sum becomes NaN, which the census of the image reports.
vec3 sum_lights(Surface s, Material m) {
    uint first = kLightCount != 0u ? 0u : push.first_light;
    uint end = kLightCount != 0u ? kLightCount : push.end_light;
    uint i = first;
    Sum3 compensated = sum_start();
    vec3 plain = vec3(0.0);
    for (; i < end; ++i) {
        vec3 term = reflect_light(s, m, arrive(read_light(i), s.position));
        if (wants(EFFECT_COMPENSATED_SUM)) sum_add(compensated, term);
        else plain += term;
    }
    vec3 sum = wants(EFFECT_COMPENSATED_SUM) ? sum_result(compensated) : plain;
    if (kLightCount == 0u && i != end) sum = vec3(uintBitsToFloat(0x7fc00000u));
    return sum;
}

vec3 shade(Surface s, Material m) {
    vec3 radiance = vec3(0.0);
    if (wants(EFFECT_EMISSION)) radiance += m.emission;
    if (wants(EFFECT_AMBIENT)) radiance += m.diffuse * push.ambient;                                             // S1
    if (wants(EFFECT_POINT_LIGHT | EFFECT_DIRECTIONAL_LIGHT | EFFECT_SPOT_LIGHT)) radiance += sum_lights(s, m);
    return radiance;
}

#endif
