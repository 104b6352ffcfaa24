// Chooses the loader by the extension, whatever its case.
#include "scene/load.h"

#include "scene/import.h"
#include "scene/limits.h"
#include "scene/nff.h"
#include "scene/paths.h"
#include "scene/problem_log.h"
#include "scene/toml_load.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace lightbench {
namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

Loaded refused(const std::filesystem::path& file, std::string why) {
    return {std::nullopt, {{file.string(), 0, 0, std::move(why)}}, 0};
}

Loaded load_toml_file(const std::filesystem::path& file, const LoadOptions& options) {
    const Bytes bytes = read_file(file, limits::kMaxTomlBytes, "kMaxTomlBytes");
    return bytes.text ? load_toml(*bytes.text, file, options) : refused(file, bytes.why);
}

} // namespace

Loaded load_scene(const std::filesystem::path& file, const LoadOptions& options) {
    const std::string extension = lower(file.extension().string());
    if (extension == ".toml") return load_toml_file(file, options);
    if (extension == ".nff") return load_nff(file, options);
    if (is_imported_format(file)) return import_file(file, options);
    const std::string what = extension.empty() ? "the name has no extension" : fmt::format("unknown extension {}", in_quotes(extension));
    return refused(file, what + "; a scene is one of .toml .nff .obj .gltf .glb .ply .stl");
}

} // namespace lightbench
