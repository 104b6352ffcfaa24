// Parts of a scene that every format adds.
#include "scene/import_scene.h"

#include "scene/import_child.h"
#include "scene/import_text.h"

#include <algorithm>

namespace lightbench::importer {

void expect_more_input(ImportJob& job, std::uint64_t bytes) {
    job.input_bytes += bytes;
    grant(allowance_for(job.input_bytes));
}

std::optional<AssimpScene> decode(ImportJob& job, std::span<const std::uint8_t> bytes) {
    const std::string main = job.format == ImportFormat::obj ? "a.obj" : job.format == ImportFormat::ply ? "a.ply" : "a.stl";
    auto read = read_with_assimp(job.format, main, {{main, bytes}});
    if (auto* scene = std::get_if<AssimpScene>(&read)) return std::move(*scene);
    job.report.problem(fmt::format("is refused by Assimp: {}", clean_name(std::get<std::string>(read))));
    return {};
}

std::uint32_t add_picture(Scene& scene, Picture picture) {
    const auto found = std::find(scene.pictures.begin(), scene.pictures.end(), picture);
    if (found != scene.pictures.end()) return static_cast<std::uint32_t>(found - scene.pictures.begin());
    scene.pictures.push_back(std::move(picture));
    return static_cast<std::uint32_t>(scene.pictures.size() - 1);
}

std::optional<std::uint32_t> add_picture_file(ImportJob& job, std::string_view name) {
    const Found found = find_named(job.around, name);
    if (found.reference == Reference::found) return add_picture(job.scene, {found.file, {}});
    if (found.reference == Reference::missing)
        job.report.remark(fmt::format("the picture {} does not exist; its surfaces have no texture", in_quotes(name)));
    else if (std::filesystem::path(name).is_absolute()) // a place on its author's machine, as exporters write them
        job.report.remark(fmt::format("the picture {} is not read without --allow-outside; its surfaces have no texture", in_quotes(name)));
    else
        job.report.problem(fmt::format("the picture {} lies outside the scene's folder; move it into the folder or give --allow-outside",
                                       in_quotes(name)));
    return {};
}

std::uint32_t add_transform(Scene& scene, const glm::dmat4& transform) {
    if (transform == glm::dmat4(1)) return 0;
    scene.transforms.push_back(transform);
    return static_cast<std::uint32_t>(scene.transforms.size() - 1);
}

void add_whole_mesh(ImportJob& job, std::span<const MeshPart> parts, bool keep_normals) {
    for (ImportedMesh& welded : weld(parts, keep_normals, job.scene.name, job.report)) {
        Object object;
        object.shape = MeshUse{static_cast<std::uint32_t>(job.scene.meshes.size())};
        object.material = welded.material;
        job.scene.meshes.push_back(std::move(welded.mesh));
        job.scene.objects.push_back(object);
    }
}

} // namespace lightbench::importer
