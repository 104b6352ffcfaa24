// A glTF 2.0 file taken apart (Khronos 2021, "glTF 2.0 Specification"). In: a .gltf or .glb. Out: its JSON and its buffers, every view and
// accessor checked to lie inside, so that whoever reads them need not look again.
#pragma once

#include "scene/gltf_value.h"
#include "scene/import_scene.h"

#include <optional>
#include <span>
#include <vector>

namespace lightbench::importer {

struct GltfDocument {
    Json json;
    std::vector<std::string> buffers;
    Report* report = nullptr;
    GltfValue root() const { return {&json, "", report}; }
};

struct GltfAccessor {
    std::uint64_t component = 0, components = 0, count = 0; // componentType; numbers an element; elements
    bool normalized = false, sparse = false;
    std::optional<std::size_t> view;
    std::uint64_t offset = 0, stride = 0; // bytes, in the view
};

// Nothing after a problem.
std::optional<GltfDocument> open_gltf(ImportJob& job);

GltfAccessor accessor_of(const GltfDocument& document, std::size_t index);
std::span<const std::uint8_t> view_of(const GltfDocument& document, std::size_t index);

// What a `uri` says: the bytes of a data URI, or the name of a file with its %XX resolved.
std::optional<std::string> data_uri(std::string_view uri, Report& report, const std::string& place);
std::string file_uri(std::string_view uri);

// Reports every view and accessor that does not lie inside what it refers to.
void check_gltf_ranges(const GltfDocument& document);

} // namespace lightbench::importer
