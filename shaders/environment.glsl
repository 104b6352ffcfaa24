// The surrounding (S12): radiance by direction, from one equirectangular picture or six faces. In: a direction of the frame, which has the
// world's axes, of any length > 0, and how much it turns from pixel to pixel. Out: radiance.
#ifndef LIGHTBENCH_ENVIRONMENT_GLSL
#define LIGHTBENCH_ENVIRONMENT_GLSL

#include "shade.glsl"
#include "lib/texels.glsl"
#include "lib/environment.glsl"

// `turn`: radians that a pixel spans along the way in which it spans most; 0 where no neighbour is known.
vec3 radiance_of(TexelInfo t, vec3 d, float turn) {
    const float kPi = 3.14159265;
    if (wants(EFFECT_SIX_FACES)) {
        vec2 uv;
        uint face = cube_face(d, uv);
        TexelInfo side = TexelInfo(t.first + face * t.height, t.width, t.width, t.flags); // height: uvec4s of a face
        return sample_trilinear(side, uv, log2(max(turn * float(t.width) * (2.0 / kPi), 1e-6))).rgb;
    }
    return sample_trilinear(t, equirect_uv(d), log2(max(turn * float(t.height) / kPi, 1e-6))).rgb;
}

// Of the scene's map.
vec3 environment_radiance(vec3 d, float turn) { return radiance_of(push.environment, d, turn); }

// What the surface mirrors: the map, or where there is none what was rendered from its object.
vec3 surrounding_radiance(Material m, vec3 d, float turn) {
    if (wants(EFFECT_RENDERED_CUBE)) return radiance_of(m.cube, d, turn);
    return environment_radiance(d, turn);
}

#endif
