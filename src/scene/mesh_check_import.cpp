// PLY and STL: checked here, decoded by Assimp. One mesh, the default material.
#include "scene/import_scene.h"
#include "scene/import_text.h"
#include "scene/mesh_check.h"

namespace lightbench::importer {

namespace {

// `keep_normals`: PLY stores them per vertex; those of STL are the facets' and say nothing that the corners do not.
void add_all(ImportJob& job, ByteView bytes, bool keep_normals) {
    const auto read = decode(job, bytes);
    if (!read) return;
    const std::uint32_t material = add_material(job.scene, Material{});
    std::vector<MeshPart> parts;
    for (unsigned i = 0; i < read->scene->mNumMeshes; ++i) parts.push_back({read->scene->mMeshes[i], material});
    add_whole_mesh(job, parts, keep_normals);
}

} // namespace

void import_ply(ImportJob& job) {
    check_ply(bytes_of(job.bytes), job.report);
    if (job.report.ok()) add_all(job, bytes_of(job.bytes), true);
}

void import_stl(ImportJob& job) {
    const ByteView triangles = check_stl(bytes_of(job.bytes), job.report);
    if (job.report.ok()) add_all(job, triangles, false);
}

} // namespace lightbench::importer
