// All pictures that shaders read, in one table of uvec4s: filtered by hand in float, so the same on every driver, from any stage, with any
// number of pictures. In: decoded pictures. Out: the table, and where each picture is in it.
//
// A uvec4 holds two texels of four half floats, in linear light; the 2^-11 that a half may be off is 1/26 of an 8-bit sRGB step at its
// worst. A picture is a header of ceil(levels / 4) uvec4s, the index in the table of each of its mip levels, then the levels, each of
// rows from the top of (width + 1) / 2 uvec4s.
#pragma once

#include "image/files.h"
#include "shared/layouts.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lightbench {

struct TexelTable {
    std::vector<std::array<std::uint32_t, 4>> words;

    // A picture whose 8-bit values are sRGB encoded (`color`) or plain numbers in [0, 1] (normal maps); floats are taken as they are, NaN and
    // infinities included, so that they are seen in what is rendered. Wraps are kWrap... of layouts.h.
    gpu_layout::TexelInfo add(const AnyImage& decoded, bool color, std::uint32_t wrap_u, std::uint32_t wrap_v);

    // The six faces of an environment, squares of one size, one after the other with one bias. Out: the first; height is the number of
    // uvec4s from one face to the next.
    gpu_layout::TexelInfo add_faces(std::span<const AnyImage> faces);

    // A height picture: its red channel's slopes d/du and d/dv as the red and green channel. They are the central differences on the texel
    // grid, taken here, in float: differences of halves would lose them (2^-11 of the height over two texels).
    gpu_layout::TexelInfo add_heights(const AnyImage& decoded, std::uint32_t wrap_u, std::uint32_t wrap_v);
};

// Nearest half float, ties to even; beyond 65519 an infinity (IEEE 754-2008, 4.3.1). NaN stays NaN.
std::uint16_t half_from_float(float x);

// The slopes that add_heights stores, per unit of u and of v (which points up).
ImageF height_slopes(const ImageF& heights, std::uint32_t wrap_u, std::uint32_t wrap_v);

} // namespace lightbench
