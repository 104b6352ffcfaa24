// A colour of the display as the word of a pixel.
#ifndef LIGHTBENCH_DISPLAY_ENCODED_GLSL
#define LIGHTBENCH_DISPLAY_ENCODED_GLSL

#include "lib/color.glsl"

//   c  linear, exposed; clamped to [0, 1]
//   returns 8-bit sRGB, red in the lowest byte, alpha 255
uint encoded(vec3 c) {
    vec3 e = srgb_encode(clamp(c, 0.0, 1.0));
    return quantize8(e.r) | quantize8(e.g) << 8 | quantize8(e.b) << 16 | 0xff000000u;
}

#endif
