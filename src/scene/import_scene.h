// What the readers of all formats share: the scene as it grows, and where it comes from.
#pragma once

#include "scene/edit.h"
#include "scene/import_assimp.h"
#include "scene/import_files.h"
#include "scene/import_mesh.h"
#include "scene/import_report.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace lightbench::importer {

struct ImportJob {
    std::filesystem::path file;
    ImportFormat format = ImportFormat::obj;
    Surroundings around;
    std::string bytes;             // of the file
    std::uint64_t input_bytes = 0; // of the file and of those that it names, as far as read
    Scene scene;
    Report report;
};

// One reader a format: bytes in, job.scene and job.report out.
void import_obj(ImportJob& job);
void import_gltf(ImportJob& job);
void import_ply(ImportJob& job);
void import_stl(ImportJob& job);

// Another file was read: the limits of the child grow with it (import_child.h).
void expect_more_input(ImportJob& job, std::uint64_t bytes);

// Assimp's scene of job.format, or nothing after a problem.
std::optional<AssimpScene> decode(ImportJob& job, std::span<const std::uint8_t> bytes);

// Index of the picture in the scene; nothing, and a remark, if it does not exist; nothing, and a problem, if it lies outside.
std::optional<std::uint32_t> add_picture_file(ImportJob& job, std::string_view name);
std::uint32_t add_picture(Scene& scene, Picture picture);
std::uint32_t add_transform(Scene& scene, const glm::dmat4& transform);

// The faces of all `parts` as one mesh in world space (two, if some have no normals).
void add_whole_mesh(ImportJob& job, std::span<const MeshPart> parts, bool keep_normals);

} // namespace lightbench::importer
