// OpenEXR in: scan lines or tiles, half, float or integer channels, any layers. The picture is the data window.
#include "image/decode.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <map>
#include <string_view>

namespace lightbench::decode {
namespace {

class MemoryStream : public Imf::IStream {
  public:
    MemoryStream(Bytes bytes, const std::string& name) : Imf::IStream(name.c_str()), bytes_(bytes) {}
    bool read(char* out, int n) override {
        if (n < 0 || static_cast<std::size_t>(n) > bytes_.size() - at_) throw std::runtime_error("it ends early");
        std::memcpy(out, bytes_.data() + at_, static_cast<std::size_t>(n));
        at_ += static_cast<std::size_t>(n);
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = std::min<std::uint64_t>(position, bytes_.size()); }

  private:
    Bytes bytes_;
    std::size_t at_ = 0;
};

// Letters in the order that people expect: colours, then coordinates, then whatever there is.
std::size_t rank(char letter) {
    return std::min(std::string_view("RGBAXYZ").find(letter), std::size_t{7});
}

std::vector<ExrLayer> described_layers(const Imf::ChannelList& channels, const std::string& path) {
    std::map<std::string, std::string> letters; // by layer; the main one, "", sorts first
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        std::string name = channel.name();
        std::size_t dot = name.rfind('.');
        std::string last = dot == std::string::npos ? name : name.substr(dot + 1);
        if (last.size() != 1) refuse(path, fmt::format("channel \"{}\": only channels of one letter can be read", name));
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            refuse(path, fmt::format("channel \"{}\": sub-sampled channels cannot be read", name));
        letters[dot == std::string::npos ? "" : name.substr(0, dot)] += last;
    }
    std::vector<ExrLayer> layers;
    for (auto& [name, chars] : letters) {
        if (chars.size() > 4) refuse(path, fmt::format("layer \"{}\" has {} channels; four can be read", name, chars.size()));
        std::sort(chars.begin(), chars.end(), [](char a, char b) { return std::pair(rank(a), a) < std::pair(rank(b), b); });
        layers.push_back({.name = name, .channels = chars, .pixels = {}});
    }
    if (layers.empty()) refuse(path, "has no channels");
    return layers;
}

// Reads `rows` lines from the y-th of the data window into the end of every layer, which grow with what was really there.
void read_rows(Imf::InputFile& file, std::vector<ExrLayer>& layers, unsigned y, unsigned rows) {
    constexpr std::size_t kPixel = 4 * sizeof(float);
    Imath::Box2i window = file.header().dataWindow();
    Imf::FrameBuffer frame;
    for (ExrLayer& layer : layers) {
        ImageF& image = layer.pixels;
        image.rgba.resize(std::size_t{y + rows} * image.width * 4);
        for (std::size_t i = 0; i < layer.channels.size(); ++i) {
            std::string name = (layer.name.empty() ? "" : layer.name + ".") + layer.channels[i];
            Imf::Slice slice =
                Imf::Slice::Make(Imf::FLOAT, image.rgba.data() + i, window.min, image.width, y + rows, kPixel, kPixel * image.width);
            frame.insert(name, slice);
        }
    }
    file.setFrameBuffer(frame);
    int first = window.min.y + static_cast<int>(y);
    file.readPixels(first, first + static_cast<int>(rows) - 1);
}

// A grey picture (Y alone) is the same in red, green and blue; a layer without alpha is opaque.
void complete(ExrLayer& layer) {
    ImageF& image = layer.pixels;
    bool grey = layer.name.empty() && (layer.channels == "Y" || layer.channels == "AY");
    bool alpha = layer.channels.size() == 4;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        float* p = &image.rgba[i];
        if (grey) {
            float y = layer.channels == "Y" ? p[0] : p[1];
            float a = layer.channels == "Y" ? 1.0f : p[0];
            p[0] = p[1] = p[2] = y;
            p[3] = a;
        } else if (!alpha) {
            p[3] = 1.0f;
        }
    }
    if (grey) layer.channels = "RGBA";
}

std::vector<ExrLayer> read_all(Bytes bytes, const std::string& path) {
    Imf::Header::setMaxImageSize(kMaxSide, kMaxSide); // checked by OpenEXR before it allocates its table of lines
    Imf::Header::setMaxTileSize(kMaxSide, kMaxSide);
    MemoryStream stream(bytes, path);
    Imf::InputFile file(stream, 0);
    Imath::Box2i window = file.header().dataWindow();
    long long width = static_cast<long long>(window.max.x) - window.min.x + 1,
              height = static_cast<long long>(window.max.y) - window.min.y + 1;
    check_size(path, width, height);
    std::vector<ExrLayer> layers = described_layers(file.header().channels(), path);
    for (ExrLayer& layer : layers) {
        layer.pixels.width = static_cast<unsigned>(width);
        layer.pixels.height = static_cast<unsigned>(height);
    }
    constexpr unsigned kRows = 64; // two of the tallest ordinary blocks (PIZ, B44: 32 lines)
    auto lines = static_cast<unsigned>(height);
    for (unsigned y = 0; y < lines; y += kRows) read_rows(file, layers, y, std::min(kRows, lines - y));
    for (ExrLayer& layer : layers) complete(layer);
    return layers;
}

} // namespace

std::vector<ExrLayer> exr(Bytes bytes, const std::string& path) {
    try {
        return read_all(bytes, path);
    } catch (const FileError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw FileError(FileError::Blame::Environment, fmt::format("{}: not enough memory to decode it", path));
    } catch (const std::exception& error) {
        refuse(path, fmt::format("cannot be decoded: {}", error.what()));
    }
}

} // namespace lightbench::decode
