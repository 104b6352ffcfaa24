// OpenEXR out: float32 channels, ZIP in blocks of 16 lines, encoded in memory and written whole.
#include "image/files.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <cstring>
#include <fmt/format.h>

namespace lightbench {
namespace {

// OpenEXR asks for a derived class here; its own file stream does not report a disk that is full at the last flush.
class MemoryStream : public Imf::OStream {
  public:
    explicit MemoryStream(const std::string& name) : Imf::OStream(name.c_str()) {}
    void write(const char* data, int n) override {
        std::size_t end = at_ + static_cast<std::size_t>(n);
        if (bytes_.size() < end) bytes_.resize(end);
        std::memcpy(bytes_.data() + at_, data, static_cast<std::size_t>(n));
        at_ = end;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t position) override { at_ = position; }
    std::span<const unsigned char> bytes() const { return bytes_; }

  private:
    std::vector<unsigned char> bytes_;
    std::size_t at_ = 0;
};

void add_channels(Imf::Header& header, Imf::FrameBuffer& frame, const std::string& prefix, const std::string& letters,
                  const ImageF& image) {
    constexpr std::size_t kPixel = 4 * sizeof(float);
    for (std::size_t i = 0; i < letters.size(); ++i) {
        std::string name = prefix + letters[i];
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        // OpenEXR's slices are not const; writing only reads them.
        char* base = reinterpret_cast<char*>(const_cast<float*>(image.rgba.data() + i));
        frame.insert(name, Imf::Slice(Imf::FLOAT, base, kPixel, kPixel * image.width));
    }
}

void check(const std::string& path, const ImageF& image, std::span<const ExrLayer> layers) {
    auto refuse = [&](const std::string& why) { throw FileError(FileError::Blame::Input, fmt::format("{}: {}", path, why)); };
    if (image.width < 1 || image.height < 1 || image.width > kMaxSide || image.height > kMaxSide)
        refuse(fmt::format("a picture of {} x {} pixels cannot be written; 1 to {} a side can", image.width, image.height, kMaxSide));
    for (const ExrLayer& layer : layers) {
        if (layer.name.empty() || layer.channels.empty() || layer.channels.size() > 4 || layer.pixels.width != image.width ||
            layer.pixels.height != image.height)
            refuse(fmt::format("layer \"{}\" must have a name, one to four channels and the size of the picture", layer.name));
    }
}

} // namespace

void write_exr(const std::string& path, const ImageF& image, std::span<const ExrLayer> layers) {
    check(path, image, layers);
    MemoryStream stream(path);
    try {
        Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
        header.compression() = Imf::ZIP_COMPRESSION;
        Imf::FrameBuffer frame;
        add_channels(header, frame, "", "RGBA", image);
        for (const ExrLayer& layer : layers) add_channels(header, frame, layer.name + ".", layer.channels, layer.pixels);
        Imf::OutputFile file(stream, header, 0); // 0: encoded by this thread
        file.setFrameBuffer(frame);
        file.writePixels(static_cast<int>(image.height));
    } catch (const std::exception& error) {
        throw FileError(FileError::Blame::Environment, fmt::format("{}: cannot be encoded: {}", path, error.what()));
    }
    write_file(path, stream.bytes());
}

} // namespace lightbench
