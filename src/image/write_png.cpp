// PNG by stb_image_write, with zlib's deflate: the built-in one has fixed Huffman codes and is slower.
#include "image/files.h"

#include <cstdlib>
#include <fmt/format.h>
#include <memory>
#include <zlib.h>

namespace {

unsigned char* deflate_for_stb(unsigned char* data, int length, int* out_length, int) {
    uLongf bound = compressBound(static_cast<uLong>(length));
    auto* out = static_cast<unsigned char*>(std::malloc(bound));
    if (out && compress2(out, &bound, data, static_cast<uLong>(length), Z_DEFAULT_COMPRESSION) != Z_OK) {
        std::free(out);
        return nullptr;
    }
    *out_length = static_cast<int>(bound);
    return out;
}

} // namespace

#define STBIW_ZLIB_COMPRESS deflate_for_stb
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace lightbench {
namespace {

bool opaque(const Image8& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        if (image.rgba[i] != 255) return false;
    }
    return true;
}

std::vector<unsigned char> without_alpha(const Image8& image) {
    std::vector<unsigned char> rgb;
    rgb.reserve(image.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) rgb.insert(rgb.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    return rgb;
}

} // namespace

void write_png(const std::string& path, const Image8& image) {
    if (image.width < 1 || image.height < 1 || image.width > kMaxSide || image.height > kMaxSide)
        throw FileError(FileError::Blame::Input, fmt::format("{}: a picture of {} x {} pixels cannot be written; 1 to {} a side can", path,
                                                             image.width, image.height, kMaxSide));
    int channels = opaque(image) ? 3 : 4;
    std::vector<unsigned char> rgb = channels == 3 ? without_alpha(image) : std::vector<unsigned char>{};
    const unsigned char* pixels = channels == 3 ? rgb.data() : image.rgba.data();
    int width = static_cast<int>(image.width), height = static_cast<int>(image.height), length = 0;
    std::unique_ptr<unsigned char, decltype(&std::free)> png(
        stbi_write_png_to_mem(pixels, width * channels, width, height, channels, &length), &std::free);
    if (!png)
        throw FileError(FileError::Blame::Environment, fmt::format("{}: not enough memory to encode {} x {} pixels", path, width, height));
    write_file(path, std::span<const unsigned char>(png.get(), static_cast<std::size_t>(length)));
}

} // namespace lightbench
