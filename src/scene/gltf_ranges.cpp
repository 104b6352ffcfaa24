// Buffer views and accessors of glTF: their place, and that it lies inside.
#include "scene/gltf_document.h"
#include "scene/import_text.h"
#include "scene/limits.h"

#include <array>
#include <cstring>

namespace lightbench::importer {

namespace {

std::uint64_t bytes_of_component(std::uint64_t type) {
    switch (type) {
    case 5120:
    case 5121: return 1;
    case 5122:
    case 5123: return 2;
    case 5125:
    case 5126: return 4;
    default: return 0;
    }
}

std::uint64_t components_of(const std::string& type) {
    constexpr std::array<std::pair<std::string_view, std::uint64_t>, 7> kTypes = {
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
    for (const auto& [name, count] : kTypes)
        if (name == type) return count;
    return 0;
}

void check_view(const GltfDocument& document, const GltfValue& view) {
    const auto buffer = view.index("buffer", document.buffers.size());
    const std::uint64_t offset = view.count("byteOffset", 0), length = view.count("byteLength", 0), stride = view.count("byteStride", 4);
    if (!view.has("buffer")) return view.problem("names no buffer");
    if (stride < 4 || stride > 252) view.problem(fmt::format("byteStride is {}; it must lie in 4 to 252", stride));
    if (buffer && offset + length > document.buffers[*buffer].size())
        view.problem(fmt::format("bytes {} to {} of a buffer of {}", offset, offset + length, document.buffers[*buffer].size()));
}

void check_accessor(const GltfDocument& document, const GltfValue& value, std::size_t index, std::size_t views) {
    if (!bytes_of_component(value.count("componentType", 0))) return value.problem("componentType is none of 5120 to 5123, 5125, 5126");
    if (!components_of(value.text("type"))) return value.problem("type is none of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4");
    if (value.count("count", 0) == 0) return value.problem("count must be 1 or more");
    if (value.count("count", 0) > limits::kMaxFileBytes)
        return value.problem(fmt::format("count is {}; the limit is {}", value.count("count", 0), limits::kMaxFileBytes));
    if (!value.index("bufferView", views) || !value.report->ok()) return;
    const GltfAccessor a = accessor_of(document, index);
    const std::uint64_t end = a.offset + (a.count - 1) * a.stride + a.components * bytes_of_component(a.component);
    const std::size_t size = view_of(document, *a.view).size();
    if (end > size) value.problem(fmt::format("its {} elements end at byte {} of a view of {}", a.count, end, size));
}

} // namespace

std::span<const std::uint8_t> view_of(const GltfDocument& document, std::size_t index) {
    const GltfValue view = document.root().array("bufferViews").item(index);
    const std::string& buffer = document.buffers[*view.index("buffer", document.buffers.size())];
    return bytes_of(buffer).subspan(view.count("byteOffset", 0), view.count("byteLength", 0));
}

GltfAccessor accessor_of(const GltfDocument& document, std::size_t index) {
    const GltfValue value = document.root().array("accessors").item(index), views = document.root().array("bufferViews");
    GltfAccessor a;
    a.component = value.count("componentType", 0), a.components = components_of(value.text("type")), a.count = value.count("count", 0);
    a.normalized = value.flag("normalized", false), a.sparse = value.has("sparse");
    a.view = value.index("bufferView", views.size());
    a.offset = value.count("byteOffset", 0);
    a.stride = a.view ? views.item(*a.view).count("byteStride", 0) : 0;
    if (a.stride == 0) a.stride = a.components * bytes_of_component(a.component);
    return a;
}

void check_gltf_ranges(const GltfDocument& document) {
    const GltfValue views = document.root().array("bufferViews"), accessors = document.root().array("accessors");
    for (std::size_t i = 0; i < views.size(); ++i)
        if (const GltfValue view = views.item(i)) check_view(document, view);
    if (!document.root().report->ok()) return;
    for (std::size_t i = 0; i < accessors.size(); ++i)
        if (const GltfValue value = accessors.item(i)) check_accessor(document, value, i, views.size());
}

} // namespace lightbench::importer
