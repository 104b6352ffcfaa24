// Pictures for a kernel: the table that the host gave to run_kernel. Its first words are the TexelInfos of the pictures.
#include "shared/layouts.h"
#include "fetch.glsl"
FETCH_TABLE(texels, FETCH_TEXELS, 3)
#include "lib/texels.glsl"

TexelInfo picture(float number) {
    uvec4 w = fetch_texels(uint(number));
    return TexelInfo(w.x, w.y, w.z, w.w);
}
vec2 argument2(uint i) { return vec2(argument(i), argument(i + 1)); }
void result4(vec4 value) {
    for (uint i = 0; i < 4; ++i) result(i, value[i]);
}
