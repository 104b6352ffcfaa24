// Picture files: what is written is read back bit for bit; what is damaged is refused with a sentence; nothing half-written is left.
#include "image/files.h"
#include "unit/image_fixtures.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <gmock/gmock.h>
#include <limits>
#include <sys/stat.h>
#include <zlib.h>

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

using namespace lightbench;
using image_test::noise;
using image_test::TemporaryFolder;
using testing::HasSubstr;

namespace {

// The sentence and the blame of the FileError that `action` must throw.
template <class Action> std::pair<std::string, FileError::Blame> refusal(Action action) {
    try {
        action();
    } catch (const FileError& error) {
        return {error.what(), error.blame};
    }
    ADD_FAILURE() << "nothing was refused";
    return {};
}

std::string refusal_of_bytes(std::span<const unsigned char> bytes) {
    return refusal([&] { decode_image(bytes, "a"); }).first;
}

void put32(std::vector<unsigned char>& out, std::uint32_t v) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<unsigned char>(v >> shift));
}

void put_chunk(std::vector<unsigned char>& out, const char* type, const std::vector<unsigned char>& data) {
    put32(out, static_cast<std::uint32_t>(data.size()));
    std::vector<unsigned char> typed(type, type + 4);
    typed.insert(typed.end(), data.begin(), data.end());
    out.insert(out.end(), typed.begin(), typed.end());
    put32(out, static_cast<std::uint32_t>(crc32(0, typed.data(), static_cast<uInt>(typed.size()))));
}

// A PNG of 8-bit grey whose data are `raw`, whatever the header claims.
std::vector<unsigned char> grey_png(std::uint32_t width, std::uint32_t height, const std::vector<unsigned char>& raw) {
    std::vector<unsigned char> png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, header;
    put32(header, width);
    put32(header, height);
    for (int v : {8, 0, 0, 0, 0}) header.push_back(static_cast<unsigned char>(v));
    uLongf length = compressBound(static_cast<uLong>(raw.size()));
    std::vector<unsigned char> data(length);
    compress2(data.data(), &length, raw.data(), static_cast<uLong>(raw.size()), 9);
    data.resize(length);
    put_chunk(png, "IHDR", header);
    put_chunk(png, "IDAT", data);
    put_chunk(png, "IEND", {});
    return png;
}

std::vector<unsigned char> jpeg_of(const Image8& image) {
    std::vector<unsigned char> bytes;
    auto append = [](void* out, void* data, int n) {
        for (int i = 0; i < n; ++i) static_cast<std::vector<unsigned char>*>(out)->push_back(static_cast<unsigned char*>(data)[i]);
    };
    stbi_write_jpg_to_func(append, &bytes, static_cast<int>(image.width), static_cast<int>(image.height), 4, image.rgba.data(), 95);
    return bytes;
}

std::vector<unsigned char> bytes_of(const char* text) {
    return {text, text + std::strlen(text)};
}

ImageF awkward_floats(unsigned width, unsigned height) {
    ImageF image{.width = width, .height = height, .rgba = std::vector<float>(std::size_t{width} * height * 4)};
    float values[] = {
        0.0f, -0.0f, 1e-45f, 3.4e38f, -1.5f, 0.1f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()};
    for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = values[i * 2654435761u % 8] * static_cast<float>(i % 97 + 1);
    return image;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

} // namespace

TEST(ImageFiles, PngComesBackBitForBit) {
    TemporaryFolder folder;
    for (auto [width, height] : {std::pair{1u, 1u}, {7u, 3u}, {1u, 300u}, {640u, 2u}}) {
        for (bool opaque : {true, false}) {
            Image8 image = noise(width, height, width, opaque);
            write_png(folder / "a.png", image);
            auto back = std::get<Image8>(read_image(folder / "a.png"));
            EXPECT_EQ(back.width, width);
            EXPECT_EQ(back.height, height);
            EXPECT_EQ(back.rgba, image.rgba) << width << "x" << height << " opaque " << opaque;
        }
    }
}

TEST(ImageFiles, PngHoldsRowsFromTheTop) {
    TemporaryFolder folder;
    auto image = std::get<Image8>(decode_image(grey_png(2, 2, {0, 10, 20, 0, 30, 40}), "grey")); // each row begins with its filter, 0
    EXPECT_EQ(image.at(1, 0)[0], 20);
    EXPECT_EQ(image.at(0, 1)[2], 30);
    EXPECT_EQ(image.at(1, 1)[3], 255);
}

TEST(ImageFiles, JpegIsNearAndItsTruncationsAreRefused) {
    Image8 image = image_test::ball_picture({.width = 64, .height = 48});
    auto bytes = jpeg_of(image);
    auto back = std::get<Image8>(decode_image(bytes, "a"));
    ASSERT_EQ(back.width, 64u);
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) sum += std::abs(image.rgba[i] - back.rgba[i]);
    EXPECT_LT(sum / static_cast<double>(image.rgba.size()), 3);
    for (std::size_t n = 0; n + 1 < bytes.size(); ++n) // the last byte is the second of the end marker
        EXPECT_FALSE(refusal_of_bytes(std::span(bytes).first(n)).empty()) << n;
    constexpr unsigned char kFrame[] = {0xff, 0xc0};
    auto size = std::search(bytes.begin(), bytes.end(), std::begin(kFrame), std::end(kFrame));
    ASSERT_NE(size, bytes.end());
    size[5] = size[7] = 0xff; // 65 000 pixels a side
    EXPECT_THAT(refusal_of_bytes(bytes), HasSubstr("16384 a side"));
}

TEST(ImageFiles, ExrComesBackBitForBit) {
    TemporaryFolder folder;
    for (auto [width, height] : {std::pair{1u, 1u}, {33u, 17u}, {5u, 200u}}) {
        ImageF image = awkward_floats(width, height);
        write_exr(folder / "a.exr", image);
        auto back = std::get<ImageF>(read_image(folder / "a.exr"));
        EXPECT_EQ(back.width, width);
        EXPECT_TRUE(same_bits(back.rgba, image.rgba));
    }
}

TEST(ImageFiles, ExrLayersComeBackUnderTheirNames) {
    TemporaryFolder folder;
    ImageF main = awkward_floats(9, 70), ambient = awkward_floats(9, 70), depth = awkward_floats(9, 70);
    for (std::size_t i = 0; i < depth.rgba.size(); i += 4) {
        ambient.rgba[i + 3] = 1;
        depth.rgba[i] = static_cast<float>(i);
        depth.rgba[i + 1] = depth.rgba[i + 2] = 0, depth.rgba[i + 3] = 1;
    }
    std::vector<ExrLayer> layers = {{"depth", "Z", depth}, {"ambient", "RGB", ambient}, {"normal", "XYZ", ambient}};
    write_exr(folder / "a.exr", main, layers);
    auto back = read_exr(folder / "a.exr");
    ASSERT_EQ(back.size(), 4u);
    EXPECT_EQ(back[0].name, "");
    EXPECT_TRUE(same_bits(back[0].pixels.rgba, main.rgba));
    EXPECT_EQ(back[1].name, "ambient");
    EXPECT_EQ(back[1].channels, "RGB");
    EXPECT_TRUE(same_bits(back[1].pixels.rgba, ambient.rgba));
    EXPECT_EQ(back[2].channels, "Z");
    EXPECT_TRUE(same_bits(back[2].pixels.rgba, depth.rgba));
    EXPECT_EQ(back[3].channels, "XYZ");
}

TEST(ImageFiles, SamePictureSameBytes) {
    TemporaryFolder folder;
    write_png(folder / "a.png", noise(50, 40, 1));
    write_png(folder / "b.png", noise(50, 40, 1));
    EXPECT_EQ(read_file(folder / "a.png"), read_file(folder / "b.png"));
    write_exr(folder / "a.exr", awkward_floats(50, 40));
    std::vector<unsigned char> first = read_file(folder / "a.exr");
    write_exr(folder / "a.exr", awkward_floats(50, 40));
    EXPECT_EQ(read_file(folder / "a.exr"), first);
}

TEST(ImageFiles, RadianceHdrFlatAndRunLengthCoded) {
    TemporaryFolder folder;
    auto flat = bytes_of("#?RADIANCE\nEXPOSURE=1\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n");
    for (int v : {128, 64, 0, 129, 1, 2, 3, 0}) flat.push_back(static_cast<unsigned char>(v));
    write_file(folder / "flat.hdr", flat);
    auto image = std::get<ImageF>(read_image(folder / "flat.hdr"));
    EXPECT_EQ(image.rgba,
              (std::vector<float>{1.0f, 0.5f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f})); // 128 * 2^(129-136) = 1; exponent 0 is black

    auto coded = bytes_of("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 9\n");
    for (int v : {2, 2, 0, 9, /*red: run*/ 137, 128, /*green: copy, run*/ 2, 64, 32, 135, 16, /*blue*/ 137, 0, /*exponent*/ 137, 129})
        coded.push_back(static_cast<unsigned char>(v));
    write_file(folder / "coded.hdr", coded);
    image = std::get<ImageF>(read_image(folder / "coded.hdr"));
    EXPECT_EQ(image.at(0, 0)[1], 0.5f);
    EXPECT_EQ(image.at(1, 0)[1], 0.25f);
    EXPECT_EQ(image.at(8, 0)[1], 0.125f);
    EXPECT_EQ(image.at(8, 0)[0], 1.0f);
}

// Every prefix of every kind of file; none may hang, crash or be taken for a picture.
TEST(ImageFiles, EveryTruncationIsRefused) {
    TemporaryFolder folder;
    write_png(folder / "a.png", noise(9, 9, 2));
    write_exr(folder / "a.exr", awkward_floats(9, 40));
    auto hdr = bytes_of("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 9\n");
    for (int row = 0; row < 2; ++row) {
        for (int v : {2, 2, 0, 9, 137, 128, 2, 64, 32, 135, 16, 137, 0, 137, 129}) hdr.push_back(static_cast<unsigned char>(v));
    }
    write_file(folder / "a.hdr", hdr);
    for (const char* name : {"a.png", "a.exr", "a.hdr"}) {
        auto whole = read_file(folder / name);
        EXPECT_NO_THROW(read_image(folder / name));
        for (std::size_t n = 0; n < whole.size(); ++n)
            EXPECT_FALSE(refusal_of_bytes(std::span(whole).first(n)).empty()) << name << " cut to " << n << " bytes";
    }
}

// A damaged PNG is always found (checksums). EXR and HDR have none: a flipped bit may only change the picture, never crash.
TEST(ImageFiles, DamagedBytesAreFoundOrHarmless) {
    TemporaryFolder folder;
    write_png(folder / "a.png", noise(9, 9, 2));
    write_exr(folder / "a.exr", awkward_floats(9, 40));
    auto png = read_file(folder / "a.png");
    for (std::size_t i = 0; i < png.size(); ++i) {
        auto damaged = png;
        damaged[i] ^= 0x10;
        EXPECT_FALSE(refusal_of_bytes(damaged).empty()) << "byte " << i;
    }
    auto exr = read_file(folder / "a.exr");
    for (std::size_t i = 0; i < exr.size(); ++i) {
        for (int flip : {0x01, 0x80, 0xff}) {
            auto damaged = exr;
            damaged[i] ^= static_cast<unsigned char>(flip);
            try {
                decode_image(damaged, "a");
            } catch (const FileError&) {
            }
        }
    }
}

TEST(ImageFiles, BombsAreRefusedBeforeTheyAreDecoded) {
    TemporaryFolder folder;
    auto start = std::chrono::steady_clock::now();
    EXPECT_THAT(refusal_of_bytes(grey_png(60000, 60000, {0, 0})), HasSubstr("60000 x 60000"));
    EXPECT_THAT(refusal_of_bytes(grey_png(16384, 16384, {0, 0})), HasSubstr("cannot hold"));
    EXPECT_THAT(refusal_of_bytes(grey_png(10, 10, std::vector<unsigned char>(64u << 20))), HasSubstr("cannot be decoded"));
    EXPECT_THAT(refusal_of_bytes(grey_png(0, 10, {0, 0})), HasSubstr("0 x 10"));
    EXPECT_THAT(refusal_of_bytes(bytes_of("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 99999 +X 99999\n")), HasSubstr("99999 x 99999"));
    EXPECT_THAT(refusal_of_bytes(bytes_of("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n")), HasSubstr("ends after"));
    EXPECT_THAT(refusal_of_bytes(bytes_of("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y -1 +X 9\n")), HasSubstr("-1"));
    write_exr(folder / "a.exr", awkward_floats(8, 8));
    auto exr = read_file(folder / "a.exr");
    auto at = std::search(exr.begin(), exr.end(), std::begin("dataWindow"), std::end("dataWindow")) + 11 + 6 + 4; // name, "box2i", size
    ASSERT_LT(at - exr.begin(), static_cast<long>(exr.size()));
    for (unsigned char high : {0x3f, 0x7f, 0x00}) {
        auto bomb = exr;
        auto max_x = bomb.begin() + (at - exr.begin()) + 8;
        for (auto field : {max_x, max_x + 4}) field[1] = 0x3f, field[3] = high; // up to 2^31, and 16135 a side within the limit
        EXPECT_FALSE(refusal_of_bytes(bomb).empty());
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(ImageFiles, WhatIsNoPictureIsNamed) {
    TemporaryFolder folder;
    EXPECT_THAT(refusal_of_bytes(bytes_of("GIF89a")), HasSubstr("not a PNG, JPEG, Radiance HDR or OpenEXR"));
    EXPECT_THAT(refusal_of_bytes({}), HasSubstr("not a PNG"));
    EXPECT_THAT(refusal([&] { read_image(folder / "none"); }).first, HasSubstr("none: cannot be opened: No such file"));
    EXPECT_EQ(refusal([&] { read_image(folder / "none"); }).second, FileError::Blame::Input);
    EXPECT_THAT(refusal([&] { read_image(folder.path().string()); }).first, HasSubstr("not a regular file"));
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    EXPECT_THAT(refusal([&] { read_image(folder / "fifo"); }).first, HasSubstr("not a regular file"));
    EXPECT_THAT(refusal([&] { read_image("/dev/zero"); }).first, HasSubstr("not a regular file"));
}

TEST(ImageFiles, AFailedWriteLeavesTheOldFileAndNothingElse) {
    TemporaryFolder folder;
    write_file(folder / "a.png", std::string_view("old"));
    Image8 empty;
    EXPECT_THAT(refusal([&] { write_png(folder / "a.png", empty); }).first, HasSubstr("0 x 0"));
    EXPECT_EQ(read_file(folder / "a.png"), bytes_of("old"));
    auto [sentence, blame] = refusal([&] { write_png(folder / "no/such/folder/a.png", noise(2, 2, 1)); });
    EXPECT_THAT(sentence, HasSubstr("No such file or directory"));
    EXPECT_EQ(blame, FileError::Blame::Input);
    auto full = refusal([&] { write_png("/dev/full", noise(2, 2, 1)); });
    EXPECT_THAT(full.first, HasSubstr("No space left"));
    EXPECT_EQ(full.second, FileError::Blame::Environment);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(ImageFiles, AWriteFollowsLinksAndSparesDevices) {
    TemporaryFolder folder;
    write_file(folder / "real", std::string_view("old"));
    std::filesystem::create_symlink("real", folder / "link");
    write_file(folder / "link", std::string_view("new"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(read_file(folder / "real"), bytes_of("new"));
    write_file("/dev/null", std::string_view("gone"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}
