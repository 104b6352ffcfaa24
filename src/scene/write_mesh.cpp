// Meshes as OBJ, for people, and as binary PLY, for size.
#include "scene/write_number.h"
#include "scene/write_parts.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <iterator>

namespace lightbench {
namespace {

constexpr std::size_t kFacesForPeople = 5000; // more than this nobody reads, and PLY is a third of the size

void append_float(std::string& out, float value) {
    char bytes[4];
    static_assert(std::endian::native == std::endian::little, "the header says little endian");
    std::memcpy(bytes, &value, 4);
    out.append(bytes, 4);
}

void append_index(std::string& out, std::uint32_t value) {
    char bytes[4];
    std::memcpy(bytes, &value, 4);
    out.append(bytes, 4);
}

void append_points(Mesh& to, const std::vector<glm::dvec3>& points) {
    for (const glm::dvec3& p : points) {
        to.corners.push_back(static_cast<std::uint32_t>(to.positions.size()));
        to.positions.emplace_back(p);
    }
    to.face_starts.push_back(static_cast<std::uint32_t>(to.corners.size()));
}

glm::vec3 moved(const glm::dmat4& world_from_object, const glm::vec3& p) {
    return glm::vec3(world_from_object * glm::dvec4(p, 1));
}

void append_mesh(Mesh& to, const Mesh& mesh, const glm::dmat4& world_from_object) {
    const auto first = static_cast<std::uint32_t>(to.positions.size()), corner = static_cast<std::uint32_t>(to.corners.size());
    for (const glm::vec3& p : mesh.positions) to.positions.push_back(moved(world_from_object, p));
    for (const std::uint32_t c : mesh.corners) to.corners.push_back(first + c);
    for (std::size_t f = 1; f < mesh.face_starts.size(); ++f) to.face_starts.push_back(corner + mesh.face_starts[f]);
}

// A mirroring transform would turn faces inside out.
void append_object(Mesh& to, const Scene& scene, const Object& object, std::string_view where, WriteLog& log) {
    const glm::dmat4& m = scene.transforms[object.transform];
    if (glm::determinant(glm::dmat3(m)) < 0) return refuse(log, "a mirroring transform", "write .toml", where);
    if (const auto* polygon = std::get_if<Polygon>(&object.shape)) {
        std::vector<glm::dvec3> points;
        for (const glm::dvec3& p : polygon->points) points.emplace_back(m * glm::dvec4(p, 1));
        append_points(to, points);
    } else if (const auto* use = std::get_if<MeshUse>(&object.shape)) {
        append_mesh(to, scene.meshes[use->mesh], m);
    } else {
        refuse(log, "a curved primitive or a box", "this format holds polygons and meshes; write .toml", where);
    }
}

// Letters, digits, - and _ of a mesh's name, the rest as -.
std::string file_name_part(std::string_view name) {
    std::string part;
    for (const char c : name.substr(0, 64)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
        part += plain ? c : '-';
    }
    return part;
}

} // namespace

// One mesh alone is taken as it is, with its normals and texture coordinates; several lose both, for they may disagree in having them.
Mesh merged_mesh(const Scene& scene, WriteLog& log) {
    if (scene.objects.size() == 1 && scene.objects[0].transform == 0)
        if (const auto* use = std::get_if<MeshUse>(&scene.objects[0].shape)) return scene.meshes[use->mesh];
    Mesh merged;
    merged.name = scene.name;
    merged.face_starts.push_back(0);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const auto* use = std::get_if<MeshUse>(&scene.objects[i].shape);
        const std::string where = fmt::format("object {}", i + 1);
        if (use && (!scene.meshes[use->mesh].normals.empty() || !scene.meshes[use->mesh].uvs.empty()))
            refuse(log, "a mesh with normals or texture coordinates of its own beside other objects", "write .toml", where);
        append_object(merged, scene, scene.objects[i], where, log);
    }
    return merged;
}

std::string obj_text(const Mesh& mesh, std::string_view comment) {
    std::string out = comment_lines(comment);
    auto to = std::back_inserter(out);
    for (const glm::vec3& p : mesh.positions) fmt::format_to(to, "v {}\n", decimals(p, " "));
    for (const glm::vec2& t : mesh.uvs) fmt::format_to(to, "vt {} {}\n", decimal(t.x), decimal(t.y));
    for (const glm::vec3& n : mesh.normals) fmt::format_to(to, "vn {}\n", decimals(n, " "));
    const bool uv = !mesh.uvs.empty(), normal = !mesh.normals.empty();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        out += 'f';
        for (std::uint32_t c = mesh.face_starts[f]; c < mesh.face_starts[f + 1]; ++c) {
            const std::uint32_t v = mesh.corners[c] + 1;
            if (uv && normal)
                fmt::format_to(to, " {}/{}/{}", v, v, v);
            else if (normal)
                fmt::format_to(to, " {}//{}", v, v);
            else if (uv)
                fmt::format_to(to, " {}/{}", v, v);
            else
                fmt::format_to(to, " {}", v);
        }
        out += '\n';
    }
    return out;
}

std::string ply_bytes(const Mesh& mesh) {
    bool many = false; // corners of a face are counted in one byte where that is enough
    for (std::size_t f = 0; f < mesh.face_count(); ++f) many |= mesh.face_starts[f + 1] - mesh.face_starts[f] > 255;
    std::string out = "ply\nformat binary_little_endian 1.0\n";
    out += fmt::format("element vertex {}\nproperty float x\nproperty float y\nproperty float z\n", mesh.positions.size());
    if (!mesh.normals.empty()) out += "property float nx\nproperty float ny\nproperty float nz\n";
    if (!mesh.uvs.empty()) out += "property float s\nproperty float t\n";
    out += fmt::format("element face {}\nproperty list {} uint vertex_indices\nend_header\n", mesh.face_count(), many ? "uint" : "uchar");
    out.reserve(out.size() + mesh.positions.size() * 32 + mesh.corners.size() * 4 + mesh.face_count() * 4);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        for (int k = 0; k < 3; ++k) append_float(out, mesh.positions[i][k]);
        for (int k = 0; k < 3 && !mesh.normals.empty(); ++k) append_float(out, mesh.normals[i][k]);
        for (int k = 0; k < 2 && !mesh.uvs.empty(); ++k) append_float(out, mesh.uvs[i][k]);
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t count = mesh.face_starts[f + 1] - mesh.face_starts[f];
        if (many)
            append_index(out, count);
        else
            out += static_cast<char>(count);
        for (std::uint32_t c = mesh.face_starts[f]; c < mesh.face_starts[f + 1]; ++c) append_index(out, mesh.corners[c]);
    }
    return out;
}

std::filesystem::path mesh_file(const Scene& scene, std::size_t i, const std::filesystem::path& scene_file) {
    const std::string own = file_name_part(scene.meshes[i].name);
    bool usable = !own.empty();
    for (std::size_t k = 0; k < scene.meshes.size(); ++k) usable &= k == i || file_name_part(scene.meshes[k].name) != own;
    const std::string name = usable ? own : fmt::format("mesh {}", i); // the blank keeps it apart from every mesh's own name
    const char* extension = scene.meshes[i].face_count() > kFacesForPeople ? "ply" : "obj";
    return scene_file.parent_path() / fmt::format("{}-{}.{}", scene_file.stem().string(), name, extension);
}

} // namespace lightbench
