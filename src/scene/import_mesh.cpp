// Welds corners into shared vertices.
#include "scene/import_mesh.h"

#include "scene/import_text.h"
#include "scene/limits.h"

#include <algorithm>
#include <assimp/mesh.h>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace lightbench::importer {

namespace {

constexpr std::uint32_t kEmpty = ~0u;

struct Vertex {
    glm::vec3 position{0}, normal{0};
    glm::vec2 uv{0};
    glm::vec4 tangent{0};
    bool operator==(const Vertex&) const = default;
};

// FNV-1a over the bits, then the finaliser of MurmurHash3 (Appleby 2011, public domain) to spread them over the low bits that the table uses.
std::uint64_t hash(const Vertex& vertex) {
    std::uint64_t h = 0xcbf29ce484222325;
    for (const float value : {vertex.position.x, vertex.position.y, vertex.position.z, vertex.normal.x, vertex.normal.y, vertex.normal.z,
                              vertex.uv.x, vertex.uv.y, vertex.tangent.x, vertex.tangent.y, vertex.tangent.z, vertex.tangent.w})
        h = (h ^ std::bit_cast<std::uint32_t>(value)) * 0x100000001b3;
    h = (h ^ (h >> 33)) * 0xff51afd7ed558ccd;
    return h ^ (h >> 33);
}

// One mesh as it grows, with an open-addressing table of its vertices.
struct Welder {
    Mesh mesh;
    bool normals = false, uvs = false, tangents = false;
    std::vector<std::uint32_t> table = std::vector<std::uint32_t>(64, kEmpty);

    Vertex vertex(std::uint32_t i) const {
        return {mesh.positions[i], normals ? mesh.normals[i] : glm::vec3(0), uvs ? mesh.uvs[i] : glm::vec2(0),
                tangents ? mesh.tangents[i] : glm::vec4(0)};
    }

    std::size_t slot(const Vertex& wanted) const {
        std::size_t at = hash(wanted) & (table.size() - 1);
        while (table[at] != kEmpty && !(vertex(table[at]) == wanted)) at = (at + 1) & (table.size() - 1);
        return at;
    }

    void grow() {
        table.assign(table.size() * 2, kEmpty);
        for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) table[slot(vertex(i))] = i;
    }

    std::uint32_t add(const Vertex& wanted) {
        if (mesh.positions.size() * 2 >= table.size()) grow();
        std::uint32_t& found = table[slot(wanted)];
        if (found != kEmpty) return found;
        found = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(wanted.position);
        if (normals) mesh.normals.push_back(wanted.normal);
        if (uvs) mesh.uvs.push_back(wanted.uv);
        if (tangents) mesh.tangents.push_back(wanted.tangent);
        return found;
    }
};

struct Dropped {
    std::size_t points = 0, lines = 0, non_finite = 0, uv = 0, normals = 0, colored = 0;
};

bool finite(const aiVector3D& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Adding 0 turns -0 into 0, so that equal values have equal bits.
glm::vec3 value_of(const aiVector3D& v) {
    return glm::vec3(v.x, v.y, v.z) + 0.0f;
}

std::optional<glm::vec3> unit(const aiVector3D& v) {
    const glm::dvec3 n(v.x, v.y, v.z);
    const double length = glm::length(n);
    if (!std::isfinite(length) || length == 0) return {};
    return glm::vec3(n / length) + 0.0f;
}

// glTF alone has tangents. Its bitangent cross(normal, tangent) w points up in the picture (glTF 2.0, sec. 3.9.3: "+Y is up"), which is the
// way of v in Scene, though v in the file grows downwards: w stays. Assimp hands on the bitangent in its place. 0 where there is no direction.
glm::vec4 tangent_of(const aiMesh& mesh, unsigned at) {
    const auto tangent = mesh.mTangents && mesh.mBitangents ? unit(mesh.mTangents[at]) : std::nullopt;
    if (!tangent) return glm::vec4(0);
    const float w = mesh.mBitangents[at] * (mesh.mNormals[at] ^ mesh.mTangents[at]);
    return w > 0 || w < 0 ? glm::vec4(*tangent, w > 0 ? 1 : -1) : glm::vec4(0);
}

enum class FaceKind { polygon, point, line, non_finite, broken };

FaceKind kind_of(const aiMesh& mesh, const aiFace& face) {
    bool is_finite = true;
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
        if (face.mIndices[i] >= mesh.mNumVertices) return FaceKind::broken;
        is_finite = is_finite && finite(mesh.mVertices[face.mIndices[i]]);
    }
    if (face.mNumIndices < 3) return face.mNumIndices < 2 ? FaceKind::point : FaceKind::line;
    return is_finite ? FaceKind::polygon : FaceKind::non_finite;
}

bool has_usable_normals(const aiMesh& mesh, const aiFace& face) {
    for (unsigned i = 0; i < face.mNumIndices; ++i)
        if (!unit(mesh.mNormals[face.mIndices[i]])) return false;
    return true;
}

void add_face(Welder& into, const aiMesh& mesh, const aiFace& face, std::uint32_t material, Dropped& dropped) {
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
        const unsigned at = face.mIndices[i];
        Vertex vertex{value_of(mesh.mVertices[at]), {}, {}, {}};
        if (into.normals) vertex.normal = *unit(mesh.mNormals[at]);
        if (into.tangents) vertex.tangent = tangent_of(mesh, at);
        if (into.uvs && mesh.mTextureCoords[0]) {
            const aiVector3D& uv = mesh.mTextureCoords[0][at];
            if (std::isfinite(uv.x) && std::isfinite(uv.y))
                vertex.uv = glm::vec2(uv.x, uv.y) + 0.0f;
            else
                ++dropped.uv;
        }
        into.mesh.corners.push_back(into.add(vertex));
    }
    into.mesh.face_starts.push_back(static_cast<std::uint32_t>(into.mesh.corners.size()));
    into.mesh.face_materials.push_back(material);
}

bool add_part(const MeshPart& part, bool keep_normals, Welder& with_normals, Welder& without, Dropped& dropped, Report& report) {
    const aiMesh& mesh = *part.mesh;
    dropped.colored += mesh.mColors[0] != nullptr;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        const FaceKind kind = kind_of(mesh, face);
        if (kind == FaceKind::broken) {
            report.problem(fmt::format("face {} of mesh {} uses a vertex beyond the {} there are", f + 1, in_quotes(mesh.mName.C_Str()),
                                       mesh.mNumVertices));
            return false;
        }
        dropped.points += kind == FaceKind::point;
        dropped.lines += kind == FaceKind::line;
        dropped.non_finite += kind == FaceKind::non_finite;
        if (kind != FaceKind::polygon) continue;
        const bool usable = keep_normals && mesh.mNormals && has_usable_normals(mesh, face);
        dropped.normals += keep_normals && mesh.mNormals && !usable;
        add_face(usable ? with_normals : without, mesh, face, part.material, dropped);
    }
    return true;
}

void remark_dropped(const Dropped& dropped, Report& report) {
    const auto counted = [&report](std::size_t count, std::string_view what) {
        if (count > 0) report.remark(fmt::format("{} {}", count, what));
    };
    counted(dropped.points, "points are not drawn");
    counted(dropped.lines, "lines are not drawn");
    counted(dropped.non_finite, "faces with a coordinate that is not finite are left out");
    counted(dropped.uv, "texture coordinates that are not finite are taken as 0");
    counted(dropped.normals, "faces have a normal without direction; their normals are computed");
    if (dropped.colored > 0) report.remark("vertex colors are not used");
}

void check_extent(const Mesh& mesh, Report& report) {
    for (const glm::vec3& p : mesh.positions) {
        const float largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        if (largest <= static_cast<float>(limits::kMaxCoordinate)) continue;
        report.problem(fmt::format("a vertex lies at {:g}; coordinates may not pass {:g}", largest, limits::kMaxCoordinate));
        return;
    }
}

// Materials move to the object where the whole mesh has but one.
ImportedMesh finished(Welder&& welder) {
    ImportedMesh result{std::move(welder.mesh), 0};
    std::vector<std::uint32_t>& materials = result.mesh.face_materials;
    result.material = materials.front();
    if (std::all_of(materials.begin(), materials.end(), [&](std::uint32_t m) { return m == materials.front(); })) materials = {};
    return result;
}

// 32-bit indices hold the corners, and the tessellator's limit holds for what it would be given.
bool fits(std::span<const MeshPart> parts, Report& report) {
    std::size_t triangles = 0;
    for (const MeshPart& part : parts)
        for (unsigned f = 0; f < part.mesh->mNumFaces; ++f) triangles += std::max(part.mesh->mFaces[f].mNumIndices, 2u) - 2;
    if (triangles <= limits::kMaxTriangles) return true;
    report.problem(fmt::format("has {} triangles; the limit is {}", triangles, limits::kMaxTriangles));
    return false;
}

} // namespace

std::vector<ImportedMesh> weld(std::span<const MeshPart> parts, bool keep_normals, const std::string& name, Report& report) {
    if (!fits(parts, report)) return {};
    Welder with_normals, without;
    Dropped dropped;
    with_normals.normals = true;
    with_normals.uvs = without.uvs =
        std::any_of(parts.begin(), parts.end(), [](const MeshPart& p) { return p.mesh->mTextureCoords[0] != nullptr; });
    with_normals.tangents =
        with_normals.uvs && std::any_of(parts.begin(), parts.end(), [](const MeshPart& p) { return p.mesh->mTangents != nullptr; });
    for (Welder* welder : {&with_normals, &without}) welder->mesh.name = name, welder->mesh.face_starts = {0};
    for (const MeshPart& part : parts)
        if (!add_part(part, keep_normals, with_normals, without, dropped, report)) return {};
    remark_dropped(dropped, report);
    std::vector<ImportedMesh> welded;
    for (Welder* welder : {&with_normals, &without}) {
        if (welder->mesh.face_count() == 0) continue;
        check_extent(welder->mesh, report);
        welded.push_back(finished(std::move(*welder)));
    }
    return welded;
}

} // namespace lightbench::importer
