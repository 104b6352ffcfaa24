// The illumination model: the only place where its terms are added up (S1 to S6, S12). Evaluated at polygon centres (flat), at vertices
// (Gouraud), at fragments (Phong). In: a point of a surface and its material. Out: the radiance that leaves it towards the viewer.
#ifndef LIGHTBENCH_SHADE_GLSL
#define LIGHTBENCH_SHADE_GLSL

#include "shared/effects.h"
#include "shared/layouts.h"
#include "fetch.glsl"
#include "lib/attenuation.glsl"
#include "lib/cook_torrance.glsl"
#include "lib/fresnel.glsl"
#include "lib/phong.glsl"
#include "lib/real.glsl"
#include "lib/spot.glsl"
#include "lib/sum.glsl"

// --precision float64: the same terms of the same inputs, in double.
#ifdef LIGHTBENCH_FLOAT64
#include "lib/float64.glsl"
#define lambert lambert_float64
#define phong_specular phong_specular_float64
#define attenuation_linear attenuation_linear_float64
#define attenuation_inverse_square attenuation_inverse_square_float64
#define spot_falloff spot_falloff_float64
#endif

layout(constant_id = CONSTANT_EFFECTS) const uint kEffects = 0u;
layout(constant_id = CONSTANT_SHADING) const uint kShading = SHADING_PHONG;
layout(constant_id = CONSTANT_OUTPUT) const uint kOutput = OUTPUT_RADIANCE;
layout(constant_id = CONSTANT_LIGHT_COUNT) const uint kLightCount = 0u;

// The ray tracer includes this with push constants of its own, which begin alike, and lets shadows fall.
#ifndef LIGHTBENCH_TRACED
layout(push_constant, scalar) uniform Push { ShadePush push; };
#endif

FETCH_TABLE(materials, FETCH_MATERIALS, 0)
FETCH_TABLE(lights, FETCH_LIGHTS, 2)
FETCH_TABLE(texels, FETCH_TEXELS, 14)

// 2^-126: keeps 1/sqrt finite at 0, and changes nothing above.
const float kLeastNormal = 1.1754944e-38;

const TexelInfo kNoTexels = TexelInfo(0u, 0u, 0u, 0u);
const Material kNoMaterial =
    Material(vec3(0.0), 0.0, vec3(0.0), 0u, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, kNoTexels, kNoTexels, vec2(0.0), 0.0, 0.0,
             vec3(0.0), 0.0, vec3(0.0), 0.0, vec4(0.0), vec4(0.0), vec4(0.0), vec3(0.0), 0.0, vec3(0.0), 0u, vec3(0.0), 0.0,
             kNoTexels);

TexelInfo texel_info(uvec4 v) { return TexelInfo(v.x, v.y, v.z, v.w); }

struct Surface {
    vec3 position;   // frame
    real3 normal;    // unit, on the side that is seen
    real3 to_viewer; // unit; read only where something is specular
};

// What a light sends to a point: the direction towards it and Ip after attenuation and spot shape, before any cosine.
struct Arrival {
    real3 l;
    real3 intensity;
};

// A macro, so that what is not wanted is gone before functions are inlined: specialising takes a fraction of the time.
#define wants(effect) ((kEffects & (effect)) != 0u)

// True if `effect` is the only one of `family` in the mask: then nobody needs to ask a light which it is.
#define only(effect, family) ((kEffects & (family)) == (effect))

bool of_kind(uint effect, uint family, uint kind, uint wanted) { return only(effect, family) || kind == wanted; }

// Only what a term of the mask reads is fetched; the rest is 0.
Material read_material(uint index) {
    uint at = wants(EFFECT_MANY_MATERIALS) ? kMaterialTexels * index : 0u;
    Material m = kNoMaterial;
    const uint detail = EFFECT_ANY_TEXTURE | EFFECT_ANY_BUMP, pictures = EFFECT_BUMP_HEIGHT | EFFECT_NORMAL_MAP;
    if (wants(EFFECT_AMBIENT | EFFECT_DIFFUSE | EFFECT_SPECULAR)) {
        uvec4 a = fetch_materials(at);
        m.diffuse = uintBitsToFloat(a.xyz), m.shininess = uintBitsToFloat(a.w);
    }
    if (wants(EFFECT_SPECULAR | EFFECT_COOK_TORRANCE | detail)) {
        uvec4 a = fetch_materials(at + 1u);
        m.specular = uintBitsToFloat(a.xyz), m.kinds = a.w;
    }
    if (wants(EFFECT_EMISSION)) m.emission = uintBitsToFloat(fetch_materials(at + 2u).xyz);
    if (wants(EFFECT_COOK_TORRANCE)) {
        uvec4 a = fetch_materials(at + 3u);
        m.ior = uintBitsToFloat(a.xyz), m.roughness = uintBitsToFloat(a.w);
    }
    if (wants(EFFECT_COOK_TORRANCE | EFFECT_TRANSPARENCY)) {
        uvec4 a = fetch_materials(at + kMaterialOpacity);
        m.opacity = uintBitsToFloat(a.xyz), m.lobe = uintBitsToFloat(a.w);
    }
    if (wants(EFFECT_TEXTURE)) m.texture = texel_info(fetch_materials(at + 5u));
    if (wants(pictures)) m.bump = texel_info(fetch_materials(at + 6u));
    if (wants(detail)) {
        uvec4 a = fetch_materials(at + 7u);
        m.repeats = uintBitsToFloat(a.xy), m.amplitude = uintBitsToFloat(a.z);
    }
    if (wants(EFFECT_BUMP_WAVES | EFFECT_BUMP_NOISE)) m.bump_scale = uintBitsToFloat(fetch_materials(at + 8u).xyz);
    if (wants(EFFECT_MIRROR_ENVIRONMENT)) m.mirror = uintBitsToFloat(fetch_materials(at + 9u).xyz);
    if (wants(EFFECT_RENDERED_CUBE)) m.cube = texel_info(fetch_materials(at + kMaterialCube));
    if (wants(EFFECT_MAP_SPHERICAL | EFFECT_MAP_CYLINDRICAL | EFFECT_MAP_PLANAR | EFFECT_BUMP_WAVES | EFFECT_BUMP_NOISE)) {
        m.map_x = uintBitsToFloat(fetch_materials(at + 10u));
        m.map_y = uintBitsToFloat(fetch_materials(at + 11u));
        m.map_z = uintBitsToFloat(fetch_materials(at + 12u));
    }
    return m;
}

// With what only traced rays ask for.
Material read_traced_material(uint index) {
    Material m = read_material(index);
    uint at = wants(EFFECT_MANY_MATERIALS) ? kMaterialTexels * index : 0u;
    uvec4 a = fetch_materials(at + kMaterialReflection), b = fetch_materials(at + kMaterialReflection + 1u),
          c = fetch_materials(at + kMaterialRefraction);
    m.reflection = uintBitsToFloat(a.xyz), m.scatter = uintBitsToFloat(a.w);
    m.transmission = uintBitsToFloat(b.xyz), m.splits = b.w;
    m.refraction = uintBitsToFloat(c.xyz);
    return m;
}

Light read_light(uint index) {
    uvec4 a = fetch_lights(4u * index), b = fetch_lights(4u * index + 1u), c = uvec4(0u), d = uvec4(0u);
    if (wants(EFFECT_SPOT_LIGHT | EFFECT_ATTENUATION_LINEAR)) c = fetch_lights(4u * index + 2u);
    if (wants(EFFECT_SPOT_LIGHT)) d = fetch_lights(4u * index + 3u);
    return Light(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.xyz), uintBitsToFloat(c.w),
                 uintBitsToFloat(d.x), uintBitsToFloat(d.y), 0.0, 0.0);
}

// Unit vector from p to the viewer; 0 where no term reads it.
real3 direction_to_viewer(vec3 p) {
    if (!wants(EFFECT_SPECULAR | EFFECT_COOK_TORRANCE | EFFECT_MIRROR_ENVIRONMENT | EFFECT_ANY_BUMP)) return real3(0.0);
    real3 to_eye = real3(push.eye) - real3(p);
    return to_eye * inversesqrt(max(dot(to_eye, to_eye), kLeastNormal));
}

// S4. The factor by which a positional light's Ip arrives at distance d.
real attenuation(Light light, real d) {
    const uint laws = EFFECT_ATTENUATION_NONE | EFFECT_ATTENUATION_LINEAR | EFFECT_ATTENUATION_INVERSE_SQUARE;
    if (only(EFFECT_ATTENUATION_LINEAR, laws)) return attenuation_linear(d, light.d0);
    if (only(EFFECT_ATTENUATION_INVERSE_SQUARE, laws)) return attenuation_inverse_square(d);
    real factor = 1.0;
    if (wants(EFFECT_ATTENUATION_LINEAR) && light.attenuation == kAttenuationLinear) factor = attenuation_linear(d, light.d0);
    if (wants(EFFECT_ATTENUATION_INVERSE_SQUARE) && light.attenuation == kAttenuationInverseSquare) factor = attenuation_inverse_square(d);
    return factor;
}

Arrival arrive_positional(Light light, vec3 p) {
    real3 to_light = real3(light.position) - real3(p);
    real d2 = max(dot(to_light, to_light), kLeastNormal); // a light at the point itself has L = 0: its terms vanish (LI-5)
    real inverse = inversesqrt(d2);
    Arrival a = Arrival(to_light * inverse, light.intensity * attenuation(light, d2 * inverse));
    const uint types = EFFECT_POINT_LIGHT | EFFECT_SPOT_LIGHT;
    if (wants(EFFECT_SPOT_LIGHT)) {
        real shape = spot_falloff(-dot(a.l, real3(light.axis)), light.cos_outer, light.cos_inner);
        a.intensity *= only(EFFECT_SPOT_LIGHT, types) || light.type == kLightSpot ? shape : 1.0;
    }
    return a;
}

Arrival arrive(Light light, vec3 p) {
    const uint types = EFFECT_POINT_LIGHT | EFFECT_SPOT_LIGHT | EFFECT_DIRECTIONAL_LIGHT;
    if (only(EFFECT_DIRECTIONAL_LIGHT, types)) return Arrival(real3(light.position), real3(light.intensity));
    if (!wants(EFFECT_DIRECTIONAL_LIGHT)) return arrive_positional(light, p);
    if (light.type == kLightDirectional) return Arrival(real3(light.position), real3(light.intensity));
    return arrive_positional(light, p);
}

// S3, S6. What multiplies ks Ip, by the material's model.
real3 highlight(Surface s, Material m, real3 l) {
    const uint models = EFFECT_SPECULAR | EFFECT_COOK_TORRANCE;
    uint model = m.kinds & 15u;
    real3 factor = real3(0.0);
    if (wants(EFFECT_SPECULAR)) {
        real phong = phong_specular(s.normal, l, s.to_viewer, m.shininess);
        if (of_kind(EFFECT_SPECULAR, models, model, kModelPhong)) factor = real3(phong);
    }
    if (wants(EFFECT_GAUSSIAN)) {
        vec3 lobe = cook_torrance_gaussian(vec3(s.normal), vec3(l), vec3(s.to_viewer), m.roughness, m.lobe, m.ior);
        if (of_kind(EFFECT_GAUSSIAN, models, model, kModelGaussian)) factor = real3(lobe);
    }
    if (wants(EFFECT_BECKMANN)) {
        vec3 lobe = cook_torrance_beckmann(vec3(s.normal), vec3(l), vec3(s.to_viewer), m.roughness, m.lobe, m.ior);
        if (of_kind(EFFECT_BECKMANN, models, model, kModelBeckmann)) factor = real3(lobe);
    }
    return factor;
}

// S15. How much of a light reaches the point, per channel.
#ifdef LIGHTBENCH_TRACED
vec3 visibility(uint light); // counted from the first of this pass
#else
vec3 visibility(uint light) { return vec3(1.0); }
#endif

// Which of the terms: what is proportional to kd, which a texture modulates, and what is not.
const uint kPartDiffuse = 1u, kPartRest = 2u, kPartAll = 3u;

// The terms of one light.
real3 reflect_light(Surface s, Material m, Arrival a, uint part) {
    if (kOutput == OUTPUT_ATTENUATION) return a.intensity;
    real3 factor = real3(0.0);
    if (wants(EFFECT_DIFFUSE) && (part & kPartDiffuse) != 0u) factor += real3(m.diffuse) * lambert(s.normal, a.l);           // S2
    if (wants(EFFECT_SPECULAR | EFFECT_COOK_TORRANCE) && (part & kPartRest) != 0u) factor += real3(m.specular) * highlight(s, m, a.l);
    return factor * a.intensity;
}

// A sum in double stalls after 2^29 times as many terms.
#ifdef LIGHTBENCH_FLOAT64
#define compensates() false
#else
#define compensates() wants(EFFECT_COMPENSATED_SUM)
#endif

// S5. All lights of this pass. A driver that ends loops early without a word (lavapipe: 65 535 iterations for eight invocations)
// is found out by the count: the sum becomes NaN, which the census of the image reports.
real3 sum_lights(Surface s, Material m, uint part) {
    uint first = kLightCount != 0u ? 0u : push.first_light;
    uint end = kLightCount != 0u ? kLightCount : push.end_light;
    uint i = first;
    Sum3 compensated = sum_start();
    real3 plain = real3(0.0);
    for (; i < end; ++i) {
        Light light = read_light(i);
        Arrival a = arrive(light, s.position);
        a.intensity *= real3(visibility(i - first));
        real3 term = reflect_light(s, m, a, part);
        if (compensates()) sum_add(compensated, vec3(term));
        else plain += term;
    }
    real3 sum = plain;
    if (compensates()) sum = real3(sum_result(compensated));
    if (kLightCount == 0u && i != end) sum = real3(uintBitsToFloat(0x7fc00000u));
    return sum;
}

real3 shade_part(Surface s, Material m, uint part) {
    real3 radiance = real3(0.0);
    if (wants(EFFECT_EMISSION) && (part & kPartRest) != 0u) radiance += real3(m.emission);
    if (wants(EFFECT_AMBIENT) && (part & kPartDiffuse) != 0u) radiance += real3(m.diffuse) * real3(push.ambient); // S1
    if (wants(EFFECT_POINT_LIGHT | EFFECT_DIRECTIONAL_LIGHT | EFFECT_SPOT_LIGHT)) radiance += sum_lights(s, m, part);
    return radiance;
}

real3 shade(Surface s, Material m) { return shade_part(s, m, kPartAll); }

// S12. What of the environment's radiance, which arrives from the mirror direction, leaves towards the viewer.
vec3 mirror_factor(Surface s, Material m) {
    vec3 factor = m.mirror;
    if (wants(EFFECT_COOK_TORRANCE)) {
        vec3 reflectance = fresnel(clamp(float(dot(s.normal, s.to_viewer)), 0.0, 1.0), m.ior);
        if ((m.kinds & 15u) != kModelPhong) factor *= reflectance;
    }
    return factor;
}

#endif
