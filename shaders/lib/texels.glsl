// Pictures, filtered by hand in float from the table of image/texels.h. Texture coordinates in, values out; u = 2^-24.
// The includer declares uvec4 fetch_texels(uint i) and includes shared/layouts.h before this file. The origin of uv is the lower left corner.
// Any uv gives a texel of the picture: coordinates are brought to [0, 1] in float before they become integers (TX-1, TX-2).
#ifndef LIGHTBENCH_LIB_TEXELS
#define LIGHTBENCH_LIB_TEXELS

const float kFarTexels = 1e8;  // a footprint's derivative is cut there, 4 decades beyond the largest picture: its fourth power is finite
const float kMostProbes = 8.0; // of an anisotropic footprint

struct TexelLevel {
    uint start;         // where its rows begin among the texels
    uint width, height;
};

uint level_count(TexelInfo t) { return t.flags & 0xffu; }

TexelLevel find_level(TexelInfo t, uint level) {
    uint start = fetch_texels(t.first + (level >> 2u))[level & 3u];
    return TexelLevel(start, max(1u, t.width >> level), max(1u, t.height >> level));
}

// What stored values are to be multiplied by: 2^(bias - 128).
float storage_scale(TexelInfo t) { return uintBitsToFloat(((t.flags >> 16u) - 1u) << 23u); }

// A coordinate as its wrap mode folds it into [0, 1]; exact but for tiny negative ones, which may become 1. What is not finite becomes 0.
float folded(float x, uint wrap) {
    float c = (floatBitsToUint(x) & 0x7f800000u) == 0x7f800000u ? 0.0 : x;
    float h = c - 2.0 * floor(0.5 * c);
    float inside = wrap == kWrapMirror ? min(h, 2.0 - h) : clamp(c, 0.0, 1.0);
    return wrap == kWrapRepeat ? c - floor(c) : inside;
}

vec2 folded(TexelInfo t, vec2 uv) { return vec2(folded(uv.x, t.flags >> 8u & 3u), folded(uv.y, t.flags >> 10u & 3u)); }

// The two texels about a coordinate, across the edge where the picture repeats.
ivec2 two_texels(int low, uint size, uint wrap) {
    int last = int(size) - 1;
    bool repeat = wrap == kWrapRepeat;
    return ivec2(low < 0 ? (repeat ? last : 0) : low, low + 1 > last ? (repeat ? 0 : last) : low + 1);
}

// row counts from the lower edge.
vec4 texel_at(TexelLevel l, int column, int row) {
    uint at = l.start + uint(int(l.height) - 1 - row) * ((l.width + 1u) >> 1u) + (uint(column) >> 1u);
    uvec4 two = fetch_texels(at);
    uvec2 one = (column & 1) != 0 ? two.zw : two.xy;
    return vec4(unpackHalf2x16(one.x), unpackHalf2x16(one.y));
}

// Stored values about a folded coordinate. Differences, not sums of weights: where all four are equal, so is the result.
vec4 between_texels(TexelInfo t, TexelLevel l, vec2 at) {
    vec2 p = at * vec2(l.width, l.height) - 0.5;
    vec2 low = floor(p), f = p - low;
    ivec2 x = two_texels(int(low.x), l.width, t.flags >> 8u & 3u), y = two_texels(int(low.y), l.height, t.flags >> 10u & 3u);
    vec4 a = texel_at(l, x.x, y.x), b = texel_at(l, x.y, y.x), c = texel_at(l, x.x, y.y), d = texel_at(l, x.y, y.y);
    vec4 lower = a + f.x * (b - a), upper = c + f.x * (d - c);
    return lower + f.y * (upper - lower);
}

// Bilinear interpolation on one level.
//   uv, level  anything; a level below the count
// Error: 4 u of the largest of the four texels, once uv is taken to be off by half an ulp of uv * size in texels (kernel test
// SampleBilinear; TX-6). Texture units may be off by 1/512 of the texels' difference.
vec4 sample_bilinear(TexelInfo t, vec2 uv, uint level) {
    return storage_scale(t) * between_texels(t, find_level(t, level), folded(t, uv));
}

// Mean of `probes` points in a row, `apart` from each other, each blended from the two levels about lod.
// The loop has two ends. Left at the bottom, it costs magnified samples one round, where Mesa 22.3.6's lavapipe, which runs a round to its end
// once begun, would do two. Without the one at the top that driver adds the last probe twice for invocations that leave before others: it
// keeps what leaves a loop apart only where two ways out meet (kernel test SampleAnisotropic).
vec4 mean_of_probes(TexelInfo t, vec2 uv, vec2 apart, uint probes, float lod) {
    float low = floor(lod), f = lod - low;
    uint count = f > 0.0 ? 2u * probes : probes; // 16 at most
    vec4 sum = vec4(0.0);
    for (uint i = 0u; i < count; ++i) {
        bool upper = i >= probes;
        float place = float(upper ? i - probes : i) - 0.5 * float(probes - 1u);
        TexelLevel l = find_level(t, uint(low) + (upper ? 1u : 0u));
        sum += (upper ? f : 1.0 - f) * between_texels(t, l, folded(t, uv + place * apart));
        if (i + 1u >= count) break;
    }
    return sum * (storage_scale(t) / float(probes));
}

// lod held to the picture's levels; a NaN counts as 0.
float held_lod(TexelInfo t, float lod) { return lod > 0.0 ? min(lod, float(level_count(t) - 1u)) : 0.0; }

// Bilinear on the two levels about lod, blended (Williams 1983, "Pyramidal parametrics").
//   lod      log2 of the texels of level 0 that the sample spans; anything, held to the levels there are
// Error: 8 u of the largest of the eight texels beside what uv's rounding does (kernel test SampleTrilinear). An integral lod costs one level.
vec4 sample_trilinear(TexelInfo t, vec2 uv, float lod) { return mean_of_probes(t, uv, vec2(0.0), 1u, held_lod(t, lod)); }

// A derivative in texels, cut where its powers would overflow; a NaN becomes the cut.
vec2 in_texels(TexelInfo t, vec2 duv) {
    vec2 d = duv * vec2(t.width, t.height);
    return mix(vec2(kFarTexels), d, lessThanEqual(abs(d), vec2(kFarTexels)));
}

// Level of an isotropic sample that spans the longer of the two derivatives (Williams 1983), in [0, levels - 1].
float lod_of(TexelInfo t, vec2 duv_dx, vec2 duv_dy) {
    vec2 a = in_texels(t, duv_dx), b = in_texels(t, duv_dy);
    return held_lod(t, 0.5 * log2(max(max(dot(a, a), dot(b, b)), 1.0)));
}

// Mean over the ellipse that a pixel's circle becomes in the picture: up to 8 trilinear probes along the major axis, each as wide as the
// minor one or an eighth of the major one. Heckbert 1989, "Fundamentals of texture mapping and image warping", sec. 3.5 (the ellipse);
// McCormack, Perry, Farkas, Jouppi 1999, "Feline" (the probes). Up to twice as long as wide the ellipse is one probe of their geometric
// mean; the width goes over continuously. Neither axis is shorter than a texel, which is what the reconstruction spans: magnified, the
// sample is one bilinear one.
//   duv_dx, duv_dy  derivatives of uv over the pixel, seams taken out (mapping.glsl, wrapped)
// Constant pictures stay constant within 16 u (kernel test SampleAnisotropic).
vec4 sample_anisotropic(TexelInfo t, vec2 uv, vec2 duv_dx, vec2 duv_dy) {
    vec2 a = in_texels(t, duv_dx), b = in_texels(t, duv_dy);
    float mean = 0.5 * (dot(a, a) + dot(b, b)), tilt = 0.5 * (a.x * a.x + b.x * b.x - a.y * a.y - b.y * b.y), off = a.x * a.y + b.x * b.y;
    float spread = sqrt(tilt * tilt + off * off), det = a.x * b.y - a.y * b.x;
    float major2 = max(mean + spread, 1.0), minor2 = max(det * det / major2, 1.0);
    float major = sqrt(major2), minor = min(sqrt(minor2), major);
    float width = max(sqrt(minor * min(major, 2.0 * minor)), major / kMostProbes);
    float probes = major < 2.0 * minor ? 1.0 : min(ceil(major / width), kMostProbes);
    vec2 axis = tilt >= 0.0 ? vec2(tilt + spread, off) : vec2(off, spread - tilt);
    axis *= inversesqrt(max(dot(axis, axis), 1e-30)); // matters only where probes > 1: then spread > 1
    vec2 apart = axis * ((major - width) / max(probes - 1.0, 1.0)) / vec2(t.width, t.height);
    return mean_of_probes(t, uv, apart, uint(probes), held_lod(t, log2(width)));
}

// Slopes dB/du and dB/dv of a height picture (TexelTable::add_heights: central differences on the texel grid).
// Blinn 1978, "Simulation of wrinkled surfaces", sec. 5 (bump functions by table).
// Error: the angle of the surface is off by at most 1e-3 rad for a sine of 128 texels a cycle and slopes up to 1 (kernel test
// HeightGradient; BM-1). With T texels a cycle the slopes fall short by (2 pi / T)^2 (1/6 + 1/8): of the difference, of the interpolation.
vec2 height_gradient(TexelInfo t, vec2 uv, float lod) { return sample_trilinear(t, uv, lod).xy; }

#endif
