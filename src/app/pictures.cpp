#include "app/pictures.h"

#include "image/files.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <regex>

namespace lightbench {
namespace {

namespace fs = std::filesystem;

const std::regex& number_pattern() {
    static const std::regex pattern("%(?:0([1-9]))?d");
    return pattern;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::size_t numbers_in(const std::string& name) {
    return static_cast<std::size_t>(
        std::distance(std::sregex_iterator(name.begin(), name.end(), number_pattern()), std::sregex_iterator()));
}

// Which components of a layer are stored, by their names.
std::string channels_of(const std::string& layer) {
    if (layer == "normal") return "XYZ";
    if (layer == "depth") return "Z";
    return layer == "object" ? "Y" : "RGB";
}

} // namespace

std::optional<Output> output_of(const std::string& path) {
    const std::string extension = lower(fs::path(path).extension().string());
    if (extension == ".png") return Output::pixels;
    if (extension == ".exr") return Output::radiance;
    return std::nullopt;
}

void check_output(const std::string& path, bool several_frames, Problems& problems) {
    const fs::path folder = fs::path(path).parent_path(), name = fs::path(path).filename();
    std::error_code ignored;
    if (!output_of(path))
        problems.push_back({"-o", 0, 0, fmt::format("\"{}\" must end in .png (a picture) or .exr (linear radiance)", path)});
    if (!folder.empty() && !fs::is_directory(folder, ignored))
        problems.push_back({"-o", 0, 0, fmt::format("there is no folder {}; it must exist", folder.string())});
    if (several_frames && numbers_in(name.string()) != 1)
        problems.push_back({"-o", 0, 0, fmt::format("\"{}\" must hold %04d once, where the number of the frame goes", path)});
}

std::string frame_path(const std::string& path, int frame) {
    const fs::path whole(path);
    const std::string name = whole.filename().string();
    std::smatch match;
    if (!std::regex_search(name, match, number_pattern())) return path;
    const int width = match[1].matched ? match[1].str()[0] - '0' : 0;
    const std::string number = fmt::format("{:0{}}", frame, width);
    return (whole.parent_path() / (match.prefix().str() + number + match.suffix().str())).string();
}

void write_pixels(const std::string& path, const Image8& pixels) {
    write_png(path, pixels);
}

void write_radiance(const std::string& path, const ImageF& radiance, const std::vector<NamedImage>& layers) {
    std::vector<ExrLayer> stored;
    for (const NamedImage& layer : layers) stored.push_back({layer.name, channels_of(layer.name), *layer.image});
    write_exr(path, radiance, stored);
}

} // namespace lightbench
