// The door of the import: checks the file in this process, reads it in a child, takes the scene over.
#include "scene/import.h"

#include "scene/import_child.h"
#include "scene/import_scene.h"
#include "scene/import_text.h"
#include "scene/import_wire.h"
#include "scene/limits.h"
#include "scene/paths.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sys/stat.h>

namespace lightbench {

namespace importer {
namespace {

std::optional<ImportFormat> format_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (extension == ".obj") return ImportFormat::obj;
    if (extension == ".gltf" || extension == ".glb") return ImportFormat::gltf;
    if (extension == ".ply") return ImportFormat::ply;
    if (extension == ".stl") return ImportFormat::stl;
    return {};
}

std::string_view kind_by_content(std::string_view text) {
    if (text.starts_with("glTF")) return "a binary glTF file";
    if (text.starts_with("ply\n") || text.starts_with("ply\r")) return "a PLY file";
    if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE")) return "text in UTF-16; save it as UTF-8";
    if (text.starts_with("\x7F"
                         "ELF"))
        return "a program";
    if (text.starts_with("PK\x03\x04")) return "a ZIP archive";
    return {};
}

// Content that says what it is, and is not what the extension says, is named; the readers see to the rest.
bool content_fits(ImportJob& job) {
    const std::string_view text = std::string_view(job.bytes).substr(0, 16);
    const std::string_view kind = kind_by_content(text);
    const bool own =
        (job.format == ImportFormat::gltf && kind == "a binary glTF file") || (job.format == ImportFormat::ply && kind == "a PLY file");
    if (text.empty())
        job.report.problem("is empty");
    else if (!kind.empty() && !own)
        job.report.problem(fmt::format("is named {} but is {}", job.file.extension().string(), kind));
    return job.report.ok();
}

void read_format(ImportJob& job) {
    switch (job.format) {
    case ImportFormat::obj: return import_obj(job);
    case ImportFormat::gltf: return import_gltf(job);
    case ImportFormat::ply: return import_ply(job);
    case ImportFormat::stl: return import_stl(job);
    }
}

void check_limits(ImportJob& job) {
    const auto limit = [&job](std::size_t count, std::size_t most, std::string_view what) {
        if (count > most) job.report.problem(fmt::format("has {} {}; the limit is {}", count, what, most));
    };
    limit(job.scene.objects.size(), limits::kMaxObjects, "objects");
    limit(job.scene.materials.size(), limits::kMaxMaterials, "materials");
    limit(job.scene.lights.size(), limits::kMaxLights, "lights");
    if (!job.scene.objects.empty() || !job.report.ok()) return;
    const std::string why =
        job.report.remarks.empty() ? "no face that can be seen" : fmt::format("{}", fmt::join(job.report.remarks, "; "));
    job.report.problem(fmt::format("has nothing to draw: {}", why));
}

// In the child: everything that touches the file's content.
void import_into(int descriptor, ImportJob& job) {
    Bytes read = read_file(job.file, limits::kMaxFileBytes, "kMaxFileBytes");
    if (read.text)
        job.bytes = std::move(*read.text), job.input_bytes = job.bytes.size();
    else
        job.report.problem(read.why);
    if (job.report.ok() && content_fits(job)) read_format(job);
    if (job.report.ok()) check_limits(job);
    Imported imported{job.report.ok() ? std::move(job.scene) : Scene{}, std::move(job.report)};
    write_imported(descriptor, imported);
}

// The size of the file, or why it is refused before a child is made.
std::variant<std::uint64_t, std::string> look_at(const std::filesystem::path& file) {
    struct stat status {};
    if (!format_of(file))
        return fmt::format("unknown extension {}; it must be .obj .gltf .glb .ply or .stl", in_quotes(file.extension().string()));
    if (::stat(file.c_str(), &status) != 0) return errno == ENOENT ? "there is no such file" : std::strerror(errno);
    if (S_ISDIR(status.st_mode)) return "it is a directory; it must be a regular file";
    if (!S_ISREG(status.st_mode)) return "it is not a regular file";
    return static_cast<std::uint64_t>(status.st_size);
}

Loaded refused(const std::filesystem::path& file, const std::string& why) {
    return {{}, {{file.string(), 0, 0, why}}, 0};
}

Loaded take_over(const std::filesystem::path& file, const ChildOutput& output) {
    if (output.failure()) return refused(file, *output.failure());
    auto imported = read_imported(output.bytes());
    if (!imported) return refused(file, "its content makes the reader fail (garbage)");
    const Report& report = imported->report;
    if (!report.ok()) return {{}, listed(report.log, file.string()), report.log.unlisted};
    Scene& scene = imported->scene;
    scene.remarks = report.remarks;
    if (report.unlisted_remarks > 0) scene.remarks.push_back(fmt::format("and {} more remarks", report.unlisted_remarks));
    return {std::move(scene), {}, 0};
}

ImportJob job_for(const std::filesystem::path& file, const LoadOptions& options, const std::filesystem::path& root) {
    ImportJob job;
    job.file = file, job.format = *format_of(file);
    job.around.folder = folder_of(file);
    job.around.root = root.empty() ? job.around.folder : root;
    job.around.allow_outside = options.allow_outside;
    job.scene.name = clean_name(file.filename().string());
    job.report.file = file.string(), job.report.log.max = options.max_problems;
    return job;
}

} // namespace
} // namespace importer

bool is_imported_format(const std::filesystem::path& file) {
    return importer::format_of(file).has_value();
}

Loaded import_file(const std::filesystem::path& file, const LoadOptions& options, const std::filesystem::path& root) {
    const auto seen = importer::look_at(file);
    if (const auto* why = std::get_if<std::string>(&seen)) return importer::refused(file, *why);
    importer::ImportJob job = importer::job_for(file, options, root);
    const auto allowance = importer::allowance_for(std::get<std::uint64_t>(seen));
    return importer::take_over(file, importer::run_in_child(allowance, [&job](int descriptor) { importer::import_into(descriptor, job); }));
}

} // namespace lightbench
