// Radiance pictures (RGBE). Own code: stb_image's reader loops for ever on a scan line that ends early.
// Ward 1991, "Real Pixels", Graphics Gems II, II.5; the run-length code as in Radiance's color.c.
#include "image/decode.h"

#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace lightbench::decode {
namespace {

struct Reader {
    Bytes bytes;
    const std::string& path;
    std::size_t at = 0;

    unsigned char byte() {
        if (at == bytes.size()) refuse(path, fmt::format("ends after {} bytes, within the picture", bytes.size()));
        return bytes[at++];
    }

    std::string line() {
        std::string text;
        for (unsigned char c; (c = byte()) != '\n';) {
            if (text.size() == 4096) refuse(path, "a header line is longer than 4096 bytes");
            text += static_cast<char>(c);
        }
        return text;
    }
};

struct Size {
    int width = 0, height = 0;
};

Size read_header(Reader& in) {
    bool rgbe = false;
    for (std::string text = in.line(); !text.empty(); text = in.line()) {
        if (text == "FORMAT=32-bit_rle_rgbe") rgbe = true;
    }
    if (!rgbe) refuse(in.path, "is not of FORMAT=32-bit_rle_rgbe, the only Radiance format that can be read");
    Size size;
    int used = 0;
    std::string text = in.line();
    if (std::sscanf(text.c_str(), "-Y %9d +X %9d%n", &size.height, &size.width, &used) != 2 || text[static_cast<std::size_t>(used)])
        refuse(in.path, fmt::format("has the orientation \"{}\"; only \"-Y height +X width\" can be read", text));
    check_size(in.path, size.width, size.height);
    return size;
}

// One component of a scan line: a count above 128 repeats the next byte count - 128 times, any other copies that many bytes.
void read_runs(Reader& in, std::span<unsigned char> line, unsigned component) {
    std::size_t width = line.size() / 4;
    for (std::size_t x = 0; x < width;) {
        unsigned count = in.byte();
        bool run = count > 128;
        if (run) count -= 128;
        if (count == 0 || count > width - x) refuse(in.path, fmt::format("has a damaged scan line before byte {}", in.at));
        unsigned char value = run ? in.byte() : 0;
        for (; count > 0; --count, ++x) line[x * 4 + component] = run ? value : in.byte();
    }
}

void read_line(Reader& in, std::span<unsigned char> line) {
    std::size_t width = line.size() / 4;
    for (unsigned i = 0; i < 4; ++i) line[i] = in.byte();
    // Only lines of 8 to 32767 pixels are ever run-length coded; their first pixel says so: 2, 2, and the width in two bytes.
    bool coded = width >= 8 && line[0] == 2 && line[1] == 2 && line[2] < 128;
    if (coded) {
        if ((std::size_t{line[2]} << 8 | line[3]) != width) refuse(in.path, fmt::format("has a damaged scan line before byte {}", in.at));
        for (unsigned component = 0; component < 4; ++component) read_runs(in, line, component);
        return;
    }
    for (std::size_t i = 4; i < line.size(); ++i) line[i] = in.byte();
}

void append_line(std::vector<float>& rgba, std::span<const unsigned char> line) {
    for (std::size_t i = 0; i < line.size(); i += 4) {
        float unit = line[i + 3] == 0 ? 0.0f : std::ldexp(1.0f, line[i + 3] - (128 + 8));
        for (std::size_t c = 0; c < 3; ++c) rgba.push_back(static_cast<float>(line[i + c]) * unit);
        rgba.push_back(1.0f);
    }
}

} // namespace

ImageF radiance_hdr(Bytes bytes, const std::string& path) {
    Reader in{.bytes = bytes, .path = path};
    Size size = read_header(in);
    ImageF image{.width = static_cast<unsigned>(size.width), .height = static_cast<unsigned>(size.height), .rgba = {}};
    std::vector<unsigned char> line(std::size_t{image.width} * 4);
    for (unsigned y = 0; y < image.height; ++y) { // grows with what was read: a short file cannot ask for much
        read_line(in, line);
        append_line(image.rgba, line);
    }
    return image;
}

} // namespace lightbench::decode
