// Picture files: PNG (display-referred) and OpenEXR (linear radiance) out; PNG, JPEG, Radiance HDR and OpenEXR in.
// Failures are FileError (image/file_bytes.h): a corrupt, truncated or oversized file is a sentence, never a crash.
#pragma once

#include "image/file_bytes.h"
#include "image/image.h"

#include <span>
#include <string>
#include <variant>
#include <vector>

namespace lightbench {

constexpr unsigned kMaxSide = 16384; // pixels; larger pictures are refused before anything is decoded

// The same picture gives the same bytes. Alpha is left out where it is 255 everywhere.
void write_png(const std::string& path, const Image8& image);

// One layer of an EXR: channel i of `pixels` is stored as "NAME.C" with C the i-th letter of `channels` ("RGB", "XYZ", "Z"; at most
// four); the main picture has no name: its channels are R, G, B, A.
struct ExrLayer {
    std::string name;
    std::string channels;
    ImageF pixels;
};

// Float32, deflated, no time stamp: the same pictures give the same bytes. All layers have the size of the image.
void write_exr(const std::string& path, const ImageF& image, std::span<const ExrLayer> layers = {});

// Every layer, the main one (empty name) first. Channels that are missing from `channels` are 0, alpha 1.
std::vector<ExrLayer> read_exr(const std::string& path);

// ImageF: linear (EXR, HDR). Image8: sRGB encoded (PNG, JPEG).
using AnyImage = std::variant<ImageF, Image8>;
AnyImage read_image(const std::string& path);
AnyImage decode_image(std::span<const unsigned char> bytes, const std::string& name); // the same from memory; the name is for messages

} // namespace lightbench
