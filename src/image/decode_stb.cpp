// PNG and JPEG by stb_image. It checks neither checksums nor how far a PNG's data inflates, so both are bounded here.
#include "image/decode.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fmt/format.h>
#include <string_view>
#include <zlib.h>

namespace {

// The largest block that stb_image may take on this thread: a PNG of 10 x 10 pixels can hold data that inflates to 4 GiB.
thread_local std::size_t largest_block = 0;

void* bounded_malloc(std::size_t n) {
    return n <= largest_block ? std::malloc(n) : nullptr;
}
void* bounded_realloc(void* p, std::size_t n) {
    return n <= largest_block ? std::realloc(p, n) : nullptr;
}

} // namespace

#define STBI_MALLOC bounded_malloc
#define STBI_REALLOC bounded_realloc
#define STBI_FREE std::free
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS 65535 // all that a JPEG can claim: check_size names the size that it refuses, before anything is decoded
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace lightbench::decode {
namespace {

std::uint32_t big_endian(Bytes b) {
    return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | b[3];
}

// W3C 2003, "Portable Network Graphics (PNG) Specification", 5.3: chunks of length, type, data and CRC, the last one IEND.
void check_png_chunks(Bytes bytes, const std::string& path) {
    for (std::size_t at = 8;;) {
        if (bytes.size() - at < 12) refuse(path, fmt::format("ends after {} bytes, within the picture", bytes.size()));
        std::size_t length = big_endian(bytes.subspan(at));
        if (length > bytes.size() - at - 12) refuse(path, fmt::format("ends after {} bytes, within the picture", bytes.size()));
        Bytes typed = bytes.subspan(at + 4, length + 4);
        if (crc32_z(0, typed.data(), typed.size()) != big_endian(bytes.subspan(at + 8 + length)))
            refuse(path, fmt::format("the chunk at byte {} is damaged (its checksum is wrong)", at));
        std::string_view type(reinterpret_cast<const char*>(typed.data()), 4);
        if (at == 8 && (type != "IHDR" || length != 13)) refuse(path, "does not begin with a PNG header");
        if (at == 8) check_size(path, big_endian(typed.subspan(4)), big_endian(typed.subspan(8)));
        if (type == "IEND") return;
        at += length + 12;
    }
}

// Deflate expands at most 1032 times (258 bytes from 2 bits), a JPEG block of 64 samples takes at least 1 bit a component: a header
// that claims more than 1032 pixels of at least 1 bit a channel and byte of file, is a lie and nothing is allocated for it.
void check_plausible(Bytes bytes, const std::string& path, int width, int height) {
    std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (pixels / 8 / 1032 > bytes.size())
        refuse(path, fmt::format("claims {} x {} pixels, which {} bytes cannot hold", width, height, bytes.size()));
}

Image8 decoded(Bytes bytes, const std::string& path) {
    int width = 0, height = 0, channels = 0;
    int length = static_cast<int>(bytes.size()); // at most kMaxReadBytes = 2^30
    largest_block = std::size_t{1} << 20;
    if (!stbi_info_from_memory(bytes.data(), length, &width, &height, &channels))
        refuse(path, fmt::format("the header cannot be read ({})", stbi_failure_reason()));
    check_size(path, width, height);
    check_plausible(bytes, path, width, height);
    // 16 bits a channel in RGBA are 8 bytes a pixel, doubled once where an interlaced picture outgrows the first guess; compressed
    // data are gathered in a block that doubles too; the rest is stb_image's own state.
    largest_block = 16 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + 2 * bytes.size() + (std::size_t{1} << 20);
    stbi_uc* pixels = stbi_load_from_memory(bytes.data(), length, &width, &height, &channels, 4);
    if (!pixels) refuse(path, fmt::format("cannot be decoded ({})", stbi_failure_reason()));
    Image8 image{.width = static_cast<unsigned>(width), .height = static_cast<unsigned>(height), .rgba = {}};
    image.rgba.assign(pixels, pixels + std::size_t{image.width} * image.height * 4);
    stbi_image_free(pixels);
    return image;
}

} // namespace

Image8 png(Bytes bytes, const std::string& path) {
    check_png_chunks(bytes, path);
    return decoded(bytes, path);
}

Image8 jpeg(Bytes bytes, const std::string& path) {
    return decoded(bytes, path);
}

} // namespace lightbench::decode
