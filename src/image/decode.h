// Decoders of one format each, from bytes in memory; `path` is for messages. Private to image/.
#pragma once

#include "image/files.h"

#include <span>
#include <string>

namespace lightbench::decode {

using Bytes = std::span<const unsigned char>;

Image8 png(Bytes bytes, const std::string& path);
Image8 jpeg(Bytes bytes, const std::string& path);
ImageF radiance_hdr(Bytes bytes, const std::string& path);
std::vector<ExrLayer> exr(Bytes bytes, const std::string& path);

[[noreturn]] void refuse(const std::string& path, const std::string& why);   // FileError that blames the input
void check_size(const std::string& path, long long width, long long height); // refuses what is not 1..kMaxSide a side

} // namespace lightbench::decode
