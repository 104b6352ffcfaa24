// Pictures to halves; where things are among the words.
#include "image/texels.h"

#include "image/display.h"
#include "image/mips.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lightbench {
namespace {

// Alpha is never encoded.
ImageF linear_picture(const AnyImage& picture, bool color) {
    if (const auto* image = std::get_if<ImageF>(&picture)) return *image;
    const Image8& image = std::get<Image8>(picture);
    std::array<float, 256> plain{}, decoded{};
    for (std::size_t i = 0; i < 256; ++i) {
        plain[i] = static_cast<float>(i) / 255.0f;
        decoded[i] = color ? linear_from_srgb(plain[i]) : plain[i];
    }
    ImageF out{.width = image.width, .height = image.height, .rgba = {}};
    out.rgba.resize(image.rgba.size());
    for (std::size_t i = 0; i < out.rgba.size(); ++i) out.rgba[i] = (i % 4 == 3 ? plain : decoded)[image.rgba[i]];
    return out;
}

// The power of two by which stored values are smaller: it brings the largest magnitude to [2^14, 2^15), the top of half's range, from
// where twenty-nine powers of two downwards are stored to 11 bits. Held to what 2^power and its inverse are normal floats for.
int storage_power(const ImageF& image) {
    float largest = 0;
    for (float x : image.rgba)
        if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
    return largest > 0 ? std::clamp(std::ilogb(largest) - 14, -126, 126) : 0;
}

std::uint32_t packed(float low, float high) {
    return std::uint32_t{half_from_float(low)} | std::uint32_t{half_from_float(high)} << 16;
}

void append_level(std::vector<std::array<std::uint32_t, 4>>& words, const ImageF& level, float scale) {
    for (unsigned y = 0; y < level.height; ++y)
        for (unsigned x = 0; x < level.width; x += 2) {
            const float* a = level.at(x, y);
            const float* b = level.at(std::min(x + 1, level.width - 1), y);
            words.push_back({packed(a[0] * scale, a[1] * scale), packed(a[2] * scale, a[3] * scale), packed(b[0] * scale, b[1] * scale),
                             packed(b[2] * scale, b[3] * scale)});
        }
}

gpu_layout::TexelInfo append(TexelTable& table, const ImageF& image, int power, std::uint32_t wrap_u, std::uint32_t wrap_v) {
    const float scale = std::ldexp(1.0f, -power);
    const std::vector<ImageF> levels = mip_chain(image);
    const std::size_t first = table.words.size();
    table.words.resize(first + (levels.size() + 3) / 4);
    for (std::size_t l = 0; l < levels.size(); ++l) {
        table.words[first + l / 4][l % 4] = static_cast<std::uint32_t>(table.words.size());
        append_level(table.words, levels[l], scale);
    }
    const auto bias = static_cast<std::uint32_t>(power + 128);
    return {.first = static_cast<std::uint32_t>(first),
            .width = image.width,
            .height = image.height,
            .flags = static_cast<std::uint32_t>(levels.size()) | wrap_u << 8 | wrap_v << 10 | bias << 16};
}

// The pixel before or after one, as the wrap has it: a mirrored border is its own neighbour, as a clamped one is.
unsigned neighbour(unsigned i, unsigned side, bool after, std::uint32_t wrap) {
    const bool repeat = wrap == gpu_layout::kWrapRepeat;
    if (after) return i + 1 < side ? i + 1 : (repeat ? 0 : i);
    return i > 0 ? i - 1 : (repeat ? side - 1 : i);
}

} // namespace

std::uint16_t half_from_float(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const std::uint32_t sign = bits >> 16 & 0x8000u, magnitude = bits & 0x7fffffffu;
    std::uint32_t half = 0;
    if (magnitude > 0x7f800000u) {
        half = 0x7e00u;
    } else if (magnitude >= 0x477ff000u) { // 65520, midway between the largest half and what would be the next
        half = 0x7c00u;
    } else if (magnitude < 0x38800000u) { // below 2^-14: multiples of 2^-24, which is the last place of 0.5
        half = std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5f) - std::bit_cast<std::uint32_t>(0.5f);
    } else {
        half = (magnitude - (112u << 23) + 0xfffu + (magnitude >> 13 & 1u)) >> 13;
    }
    return static_cast<std::uint16_t>(sign | half);
}

ImageF height_slopes(const ImageF& heights, std::uint32_t wrap_u, std::uint32_t wrap_v) {
    const unsigned w = heights.width, h = heights.height;
    ImageF out{.width = w, .height = h, .rgba = {}};
    out.rgba.resize(std::size_t{w} * h * 4);
    for (unsigned y = 0; y < h; ++y)
        for (unsigned x = 0; x < w; ++x) {
            const float right = heights.at(neighbour(x, w, true, wrap_u), y)[0], left = heights.at(neighbour(x, w, false, wrap_u), y)[0];
            const float above = heights.at(x, neighbour(y, h, false, wrap_v))[0], below = heights.at(x, neighbour(y, h, true, wrap_v))[0];
            out.at(x, y)[0] = 0.5f * static_cast<float>(w) * (right - left);
            out.at(x, y)[1] = 0.5f * static_cast<float>(h) * (above - below);
        }
    return out;
}

gpu_layout::TexelInfo TexelTable::add(const AnyImage& decoded, bool color, std::uint32_t wrap_u, std::uint32_t wrap_v) {
    const ImageF image = linear_picture(decoded, color);
    return append(*this, image, storage_power(image), wrap_u, wrap_v);
}

gpu_layout::TexelInfo TexelTable::add_faces(std::span<const AnyImage> faces) {
    std::vector<ImageF> images;
    for (const AnyImage& face : faces) images.push_back(linear_picture(face, true));
    int power = storage_power(images.front());
    for (const ImageF& image : images) power = std::max(power, storage_power(image));
    const auto start = static_cast<std::uint32_t>(words.size());
    gpu_layout::TexelInfo first = append(*this, images.front(), power, gpu_layout::kWrapClamp, gpu_layout::kWrapClamp);
    first.height = static_cast<std::uint32_t>(words.size()) - start;
    for (std::size_t i = 1; i < images.size(); ++i) append(*this, images[i], power, gpu_layout::kWrapClamp, gpu_layout::kWrapClamp);
    return first;
}

gpu_layout::TexelInfo TexelTable::add_heights(const AnyImage& decoded, std::uint32_t wrap_u, std::uint32_t wrap_v) {
    const ImageF slopes = height_slopes(linear_picture(decoded, false), wrap_u, wrap_v);
    return append(*this, slopes, storage_power(slopes), wrap_u, wrap_v);
}

} // namespace lightbench
