// OBJ: checked line by line, its libraries read here, its geometry by Assimp. Groups and objects of the file become one mesh, so that
// smoothing crosses their borders.
#include "scene/import_scene.h"
#include "scene/import_text.h"
#include "scene/limits.h"
#include "scene/obj_check.h"
#include "scene/obj_material.h"
#include "scene/paths.h"

#include <set>

namespace lightbench::importer {

namespace {

using MaterialIndices = std::map<std::string, std::uint32_t, std::less<>>; // of the scene, by usemtl name

// Names may hold blanks, or be several in a line: the whole rest of the line is tried first.
std::vector<std::string> library_names(const Surroundings& around, std::string_view rest) {
    if (find_named(around, rest).reference != Reference::missing) return {std::string(rest)};
    std::vector<std::string> names;
    bool any = false;
    for (std::string_view list = rest, word; !(word = next_word(list)).empty();) {
        names.emplace_back(word);
        any = any || find_named(around, word).reference != Reference::missing;
    }
    return any ? names : std::vector{std::string(rest)};
}

void read_library(ImportJob& job, const ObjName& line, const std::string& name, MtlLibrary& library) {
    const Found found = find_named(job.around, name);
    if (found.reference == Reference::outside)
        return job.report.problem_at(
            line.line,
            fmt::format("the material library {} lies outside the scene's folder; move it into the folder or give --allow-outside",
                        in_quotes(name)));
    if (found.reference == Reference::missing)
        return job.report.remark(fmt::format("line {}: the material library {} does not exist", line.line, in_quotes(name)));
    const Bytes read = read_file(found.file, limits::kMaxFileBytes, "kMaxFileBytes");
    if (!read.text) return job.report.problem_at(line.line, fmt::format("the material library {}: {}", in_quotes(name), read.why));
    expect_more_input(job, read.text->size());
    read_mtl(*read.text, found.file.string(), library, job.report);
}

MtlLibrary read_libraries(ImportJob& job, const ObjContents& contents) {
    MtlLibrary library;
    std::set<std::string> seen;
    for (const ObjName& line : contents.libraries)
        for (const std::string& name : library_names(job.around, line.name)) {
            if (!seen.insert(name).second) continue;
            if (seen.size() <= limits::kMaxIncludes)
                read_library(job, line, name, library);
            else
                return job.report.problem_at(line.line, fmt::format("names more than {} material libraries", limits::kMaxIncludes)),
                       library;
        }
    return library;
}

Texture texture_of(std::uint32_t picture, const MtlMap& map) {
    const Wrap wrap = map.clamp ? Wrap::clamp : Wrap::repeat;
    return {picture, Mapping::uv, map.scale, wrap, wrap};
}

Material with_pictures(ImportJob& job, const MtlMaterial& entry) {
    Material material = entry.material;
    if (entry.diffuse_map)
        if (const auto picture = add_picture_file(job, entry.diffuse_map->file))
            material.texture = texture_of(*picture, *entry.diffuse_map);
    if (!entry.bump_map) return material;
    if (const auto picture = add_picture_file(job, entry.bump_map->file)) {
        Bump bump;
        bump.picture = picture, bump.normal_map = entry.bump_map->normal_map;
        bump.amplitude *= entry.bump_map->strength;
        material.bump = bump;
    }
    return material;
}

// The scene's materials are those that faces use. One name stands for each that no library defines, since nothing is known of them.
MaterialIndices add_materials(ImportJob& job, const ObjContents& contents, const MtlLibrary& library) {
    MaterialIndices indices;
    std::size_t undefined = 0;
    std::string first;
    for (const ObjName& use : contents.materials) {
        const auto found = library.find(use.name);
        if (found != library.end())
            indices[use.name] = add_material(job.scene, with_pictures(job, found->second));
        else if (undefined++ == 0)
            first = fmt::format("{} in line {}", in_quotes(use.name), use.line);
    }
    if (undefined > 0) job.report.remark(fmt::format("{} materials are not defined and get the default one, first {}", undefined, first));
    return indices;
}

void add_geometry(ImportJob& job, const AssimpScene& read, const MaterialIndices& materials) {
    std::vector<MeshPart> parts;
    std::optional<std::uint32_t> plain;
    for (unsigned i = 0; i < read.scene->mNumMeshes; ++i) {
        const aiMesh* mesh = read.scene->mMeshes[i];
        const aiString name = read.scene->mMaterials[mesh->mMaterialIndex]->GetName();
        const auto found = materials.find(std::string_view(name.C_Str()));
        if (found == materials.end() && !plain) plain = add_material(job.scene, Material{});
        parts.push_back({mesh, found != materials.end() ? found->second : *plain});
    }
    add_whole_mesh(job, parts, true);
}

} // namespace

void import_obj(ImportJob& job) {
    const ObjContents contents = check_obj(job.bytes, job.report);
    const MtlLibrary library = read_libraries(job, contents);
    if (!job.report.ok()) return;
    const auto materials = add_materials(job, contents, library);
    const auto read = decode(job, bytes_of(job.bytes));
    if (read && job.report.ok()) add_geometry(job, *read, materials);
}

} // namespace lightbench::importer
