// Primitives of glTF: checked, their integers made floats, then through Assimp.
#include "scene/gltf_mesh.h"

#include "scene/gltf_material.h"
#include "scene/import_text.h"

#include <algorithm>
#include <cstring>

namespace lightbench::importer {

namespace {

struct Primitive {
    std::size_t mesh = 0;
    std::uint32_t material = 0;
    Json json; // as Assimp shall see it
};

struct Geometry {
    ImportJob& job;
    const GltfDocument& document;
    Json accessors, views; // those of the file, and converted ones
    std::string converted; // the buffer of the converted ones
    std::map<std::size_t, std::size_t> as_floats;
};

template <class T> T load(std::span<const std::uint8_t> bytes, std::uint64_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

// Section 3.6.2.2: normalized integers c are max(c / most, -1).
float component(std::span<const std::uint8_t> bytes, std::uint64_t at, const GltfAccessor& a) {
    const auto scaled = [&a](double value, double most) { return static_cast<float>(a.normalized ? std::max(value / most, -1.0) : value); };
    switch (a.component) {
    case 5120: return scaled(load<std::int8_t>(bytes, at), 127);
    case 5121: return scaled(load<std::uint8_t>(bytes, at), 255);
    case 5122: return scaled(load<std::int16_t>(bytes, at), 32767);
    case 5123: return scaled(load<std::uint16_t>(bytes, at), 65535);
    case 5125: return scaled(load<std::uint32_t>(bytes, at), 4294967295.0);
    default: return load<float>(bytes, at);
    }
}

// Assimp 5.2 takes the bytes of any attribute for floats (KHR_mesh_quantization; integer texture coordinates are in the core): a copy.
std::size_t convert(Geometry& geometry, std::size_t index, const GltfAccessor& a) {
    const auto bytes = view_of(geometry.document, *a.view);
    const std::uint64_t size = a.component <= 5121 ? 1 : a.component <= 5123 ? 2 : 4, first = geometry.converted.size();
    for (std::uint64_t i = 0; i < a.count; ++i)
        for (std::uint64_t c = 0; c < a.components; ++c) {
            const float value = component(bytes, a.offset + i * a.stride + c * size, a);
            geometry.converted.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
    geometry.views.push_back(
        {{"buffer", geometry.document.buffers.size()}, {"byteOffset", first}, {"byteLength", geometry.converted.size() - first}});
    geometry.accessors.push_back({{"bufferView", geometry.views.size() - 1},
                                  {"componentType", 5126},
                                  {"count", a.count},
                                  {"type", geometry.accessors[index]["type"]}});
    return geometry.as_floats[index] = geometry.accessors.size() - 1;
}

std::optional<std::size_t> float_accessor(Geometry& geometry, const GltfValue& attributes, const char* key, std::uint64_t components) {
    const auto index = attributes.index(key, geometry.document.root().array("accessors").size());
    if (!index) return {};
    const GltfAccessor a = accessor_of(geometry.document, *index);
    if (a.components != components)
        return attributes.problem(fmt::format("{} must have {} components; it has {}", key, components, a.components)), std::nullopt;
    if (a.component == 5126) return index;
    if (const auto known = geometry.as_floats.find(*index); known != geometry.as_floats.end()) return known->second;
    if (a.view && !a.sparse) return convert(geometry, *index, a);
    return attributes.problem(fmt::format("{}: sparse integers are not read", key)), std::nullopt;
}

bool check_indices(const Geometry& geometry, const GltfValue& primitive, std::size_t index, std::uint64_t vertices) {
    const GltfAccessor a = accessor_of(geometry.document, index);
    if (a.components != 1 || (a.component != 5121 && a.component != 5123 && a.component != 5125))
        return primitive.problem("its indices must be unsigned integers of type SCALAR"), false;
    if (!a.view || a.sparse) return true; // weld() checks what Assimp makes of them
    const auto bytes = view_of(geometry.document, *a.view);
    for (std::uint64_t i = 0; i < a.count; ++i) {
        const std::uint64_t at = a.offset + i * a.stride;
        const std::uint32_t value = a.component == 5121   ? load<std::uint8_t>(bytes, at)
                                    : a.component == 5123 ? load<std::uint16_t>(bytes, at)
                                                          : load<std::uint32_t>(bytes, at);
        if (value >= vertices)
            return primitive.problem(fmt::format("index {} is {}; there are {} vertices, counted from 0", i, value, vertices)), false;
    }
    return true;
}

std::uint64_t count_of(const Geometry& geometry, std::size_t index) {
    return geometry.accessors[index]["count"].get<std::uint64_t>();
}

void add_optional(Geometry& geometry, const GltfValue& attributes, const std::string& key, const char* as, std::uint64_t components,
                  Json& into) {
    const auto accessor = float_accessor(geometry, attributes, key.c_str(), components);
    if (!accessor) return;
    if (count_of(geometry, *accessor) == count_of(geometry, into["POSITION"].get<std::size_t>()))
        into[as] = *accessor;
    else
        geometry.job.report.remark(fmt::format("{}: {} does not have one entry a vertex and is not used", attributes.place, key));
}

bool is_drawn(Geometry& geometry, const GltfValue& primitive, std::uint64_t mode) {
    if (mode > 6) return primitive.problem(fmt::format("mode is {}; it must lie in 0 to 6", mode)), false;
    if (mode < 4) geometry.job.report.remark("primitives of points and lines are not drawn");
    if (primitive.has("targets")) geometry.job.report.remark("morph targets are not used: the shape without them is drawn");
    if (primitive.object("attributes").has("COLOR_0")) geometry.job.report.remark("vertex colors are not used");
    return mode >= 4;
}

std::optional<Primitive> read_primitive(Geometry& geometry, const GltfValue& value, std::size_t mesh, GltfMaterials& materials) {
    const GltfValue attributes = value.object("attributes");
    const std::uint64_t mode = value.count("mode", 4);
    if (!attributes || !is_drawn(geometry, value, mode)) return {};
    const auto position = float_accessor(geometry, attributes, "POSITION", 3);
    if (!position)
        return geometry.job.report.ok() ? geometry.job.report.remark("primitives without positions are not drawn") : void(), std::nullopt;
    Primitive primitive{mesh, 0, {}};
    const GltfMaterial material = material_for(geometry.job, geometry.document,
                                               value.index("material", geometry.document.root().array("materials").size()), materials);
    primitive.material = material.material;
    Json kept = {{"POSITION", *position}};
    add_optional(geometry, attributes, "NORMAL", "NORMAL", 3, kept);
    if (kept.contains("NORMAL")) add_optional(geometry, attributes, "TANGENT", "TANGENT", 4, kept);
    add_optional(geometry, attributes, fmt::format("TEXCOORD_{}", material.uv_set), "TEXCOORD_0", 2, kept);
    primitive.json = {{"attributes", kept}, {"mode", mode}};
    const auto indices = value.index("indices", geometry.document.root().array("accessors").size());
    if (indices && check_indices(geometry, value, *indices, count_of(geometry, *position))) primitive.json["indices"] = *indices;
    return primitive;
}

std::vector<Primitive> read_primitives(Geometry& geometry, const std::set<std::size_t>& used) {
    std::vector<Primitive> all;
    GltfMaterials materials;
    const GltfValue meshes = geometry.document.root().array("meshes");
    for (const std::size_t mesh : used) {
        const GltfValue primitives = meshes.item(mesh).array("primitives");
        for (std::size_t i = 0; i < primitives.size(); ++i)
            if (const GltfValue value = primitives.item(i))
                if (auto primitive = read_primitive(geometry, value, mesh, materials)) all.push_back(std::move(*primitive));
    }
    return all;
}

// One mesh and one node a primitive; Assimp names its mesh as we do.
std::string geometry_only(const Geometry& geometry, const std::vector<Primitive>& primitives) {
    Json buffers = Json::array(), meshes = Json::array(), nodes = Json::array(), roots = Json::array();
    for (std::size_t i = 0; i < geometry.document.buffers.size(); ++i)
        buffers.push_back({{"uri", fmt::format("{}.bin", i)}, {"byteLength", geometry.document.buffers[i].size()}});
    if (!geometry.converted.empty())
        buffers.push_back({{"uri", fmt::format("{}.bin", geometry.document.buffers.size())}, {"byteLength", geometry.converted.size()}});
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        meshes.push_back({{"name", fmt::format("{}", i)}, {"primitives", Json::array({primitives[i].json})}});
        nodes.push_back({{"mesh", i}});
        roots.push_back(i);
    }
    const Json json = {{"asset", {{"version", "2.0"}}},
                       {"buffers", buffers},
                       {"bufferViews", geometry.views},
                       {"accessors", geometry.accessors},
                       {"meshes", meshes},
                       {"nodes", nodes},
                       {"scenes", Json::array({Json{{"nodes", roots}}})},
                       {"scene", 0}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<AssimpScene> decode(const Geometry& geometry, const std::string& text) {
    MemoryFiles files = {{"a.gltf", bytes_of(text)}};
    for (std::size_t i = 0; i < geometry.document.buffers.size(); ++i)
        files[fmt::format("{}.bin", i)] = bytes_of(geometry.document.buffers[i]);
    files[fmt::format("{}.bin", geometry.document.buffers.size())] = bytes_of(geometry.converted);
    auto read = read_with_assimp(ImportFormat::gltf, "a.gltf", files);
    if (auto* scene = std::get_if<AssimpScene>(&read)) return std::move(*scene);
    geometry.job.report.problem(fmt::format("is refused by Assimp: {}", clean_name(std::get<std::string>(read))));
    return {};
}

std::vector<GltfMeshUse> add_mesh(ImportJob& job, const GltfDocument& document, std::size_t mesh, const std::vector<MeshPart>& parts) {
    std::string name = clean_name(document.root().array("meshes").item(mesh).text("name"));
    if (name.empty()) name = fmt::format("meshes[{}]", mesh);
    std::vector<GltfMeshUse> uses;
    for (ImportedMesh& welded : weld(parts, true, name, job.report)) {
        uses.push_back({static_cast<std::uint32_t>(job.scene.meshes.size()), welded.material});
        job.scene.meshes.push_back(std::move(welded.mesh));
    }
    return uses;
}

// What only geometry needs of views and accessors; names, extremes and extensions may hold anything.
Json stripped(const GltfValue& list, std::initializer_list<const char*> keys) {
    Json kept = Json::array();
    for (std::size_t i = 0; i < list.size(); ++i) {
        Json entry = Json::object();
        for (const char* key : keys)
            if ((*list.json)[i].contains(key)) entry[key] = (*list.json)[i][key];
        kept.push_back(std::move(entry));
    }
    return kept;
}

} // namespace

std::map<std::size_t, std::vector<GltfMeshUse>> add_gltf_meshes(ImportJob& job, const GltfDocument& document,
                                                                const std::set<std::size_t>& used) {
    Geometry geometry{job,
                      document,
                      stripped(document.root().array("accessors"),
                               {"bufferView", "byteOffset", "componentType", "normalized", "count", "type", "sparse"}),
                      stripped(document.root().array("bufferViews"), {"buffer", "byteOffset", "byteLength", "byteStride"}),
                      {},
                      {}};
    const std::vector<Primitive> primitives = read_primitives(geometry, used);
    if (!job.report.ok() || primitives.empty()) return {};
    const auto read = decode(geometry, geometry_only(geometry, primitives));
    if (!read) return {};
    std::map<std::size_t, std::vector<MeshPart>> parts;
    for (unsigned i = 0; i < read->scene->mNumMeshes; ++i) {
        const auto index = parse_integer(read->scene->mMeshes[i]->mName.C_Str());
        if (!index || *index < 0 || *index >= static_cast<long long>(primitives.size())) continue;
        const Primitive& primitive = primitives[static_cast<std::size_t>(*index)];
        parts[primitive.mesh].push_back({read->scene->mMeshes[i], primitive.material});
    }
    std::map<std::size_t, std::vector<GltfMeshUse>> meshes;
    for (const auto& [mesh, list] : parts) meshes[mesh] = add_mesh(job, document, mesh, list);
    return meshes;
}

} // namespace lightbench::importer
