// Chooses the decoder by the file's first bytes, never by its name.
#include "image/decode.h"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

namespace lightbench {
namespace {

bool starts_with(decode::Bytes bytes, std::string_view magic) {
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin(),
                                                      [](char c, unsigned char b) { return static_cast<unsigned char>(c) == b; });
}

ImageF main_layer(std::vector<ExrLayer> layers, const std::string& path) {
    if (!layers.front().name.empty()) decode::refuse(path, "has no channels R, G, B or Y of its own, only layers");
    return std::move(layers.front().pixels);
}

} // namespace

namespace decode {

void refuse(const std::string& path, const std::string& why) {
    throw FileError(FileError::Blame::Input, fmt::format("{}: {}", path, why));
}

void check_size(const std::string& path, long long width, long long height) {
    if (width >= 1 && height >= 1 && width <= kMaxSide && height <= kMaxSide) return;
    refuse(path, fmt::format("claims {} x {} pixels; 1 to {} a side can be read", width, height, kMaxSide));
}

} // namespace decode

std::vector<ExrLayer> read_exr(const std::string& path) {
    return decode::exr(read_file(path), path);
}

AnyImage read_image(const std::string& path) {
    return decode_image(read_file(path), path);
}

AnyImage decode_image(std::span<const unsigned char> bytes, const std::string& name) {
    if (starts_with(bytes, "\x89PNG\r\n\x1a\n")) return decode::png(bytes, name);
    if (starts_with(bytes, "\xff\xd8\xff")) return decode::jpeg(bytes, name);
    if (starts_with(bytes, "#?")) return decode::radiance_hdr(bytes, name);
    if (starts_with(bytes, "\x76\x2f\x31\x01")) return main_layer(decode::exr(bytes, name), name);
    decode::refuse(name, "not a PNG, JPEG, Radiance HDR or OpenEXR picture");
}

} // namespace lightbench
