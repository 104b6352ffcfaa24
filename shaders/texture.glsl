// Textures where they are looked up (S10). In: a material and where a pixel lies in its picture. Out: what kd is multiplied by, and alpha.
#ifndef LIGHTBENCH_TEXTURE_GLSL
#define LIGHTBENCH_TEXTURE_GLSL

#include "detail.glsl"

// Picture coordinates and how they change from pixel to pixel; around a sphere or a cylinder they jump by 1 at the seam (TX-5).
struct Footprint {
    vec2 at, dx, dy;
};

// The checker's dark squares, of its bright ones' kd.
const float kDarkSquare = 0.2;

// S10. What kd is multiplied by, and its alpha.
vec4 texture_color(Material m, Footprint f) {
    vec4 color = vec4(1.0);
    uint kind = (m.kinds >> 4u) & 15u;
    if (wants(EFFECT_TEXTURE)) {
        vec4 sampled = sample_anisotropic(m.texture, f.at, f.dx, f.dy);
        if (kind == kTexturePicture || kind == kTextureWithAlpha) color = vec4(sampled.rgb, kind == kTextureWithAlpha ? sampled.a : 1.0);
    }
    if (wants(EFFECT_CHECKER)) {
        float bright = checker(f.at, f.dx, f.dy);
        if (kind == kTextureChecker) color.rgb = vec3(mix(kDarkSquare, 1.0, bright));
    }
    return color;
}

#endif
