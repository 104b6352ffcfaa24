// The door of the import: checks the file in this process, reads it in a child, takes the scene over.
#include "scene/import.h"

#include "scene/import_child.h"
#include "scene/import_scene.h"
#include "scene/import_text.h"
#include "scene/import_wire.h"
#include "scene/limits.h"

#include <algorithm>
#include <sys/stat.h>

namespace lightbench {

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
    const std::string_view text(reinterpret_cast<const char*>(job.bytes.data()), std::min<std::size_t>(job.bytes.size(), 16));
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
    auto read = read_whole_file(job.file);
    if (const auto* why = std::get_if<std::string>(&read))
        job.report.problem(*why);
    else
        job.bytes = std::move(std::get<Bytes>(read)), job.input_bytes = job.bytes.size();
    if (job.report.ok() && content_fits(job)) read_format(job);
    if (job.report.ok()) check_limits(job);
    job.report.count_unlisted();
    Imported imported{job.report.ok() ? std::move(job.scene) : Scene{}, std::move(job.report)};
    write_imported(descriptor, imported);
}

std::optional<std::string> refused_by_sight(const std::filesystem::path& file, struct stat& status) {
    if (!format_of(file))
        return fmt::format("the extension {} is not one of .obj .gltf .glb .ply .stl", in_quotes(file.extension().string()));
    if (::stat(file.c_str(), &status) != 0) return "does not exist or cannot be reached";
    if (S_ISDIR(status.st_mode)) return "is a folder, not a file";
    if (!S_ISREG(status.st_mode)) return "is not a regular file";
    return {};
}

Loaded take_over(const std::filesystem::path& file, const ChildOutput& output) {
    if (output.failure()) return {{}, {{file.string(), 0, 0, *output.failure()}}};
    auto imported = read_imported(output.bytes());
    if (!imported) return {{}, {{file.string(), 0, 0, "its content makes the reader fail (garbage)"}}};
    if (!imported->report.ok()) return {{}, std::move(imported->report.problems)};
    for (std::string& remark : imported->report.remarks) imported->scene.remarks.push_back(imported->scene.name + ": " + remark);
    return {std::move(imported->scene), {}};
}

} // namespace

bool is_imported_format(const std::filesystem::path& file) {
    return format_of(file).has_value();
}

Loaded import_file(const std::filesystem::path& file, const LoadOptions& options, const std::filesystem::path& root) {
    struct stat status {};
    if (const auto why = refused_by_sight(file, status)) return {{}, {{file.string(), 0, 0, *why}}};
    ImportJob job;
    job.file = file, job.format = *format_of(file);
    job.around.folder = file.has_parent_path() ? file.parent_path() : ".";
    job.around.root = root.empty() ? job.around.folder : root;
    job.around.allow_outside = options.allow_outside;
    job.scene.name = clean_name(file.filename().string());
    job.report.file = file.string(), job.report.max_problems = options.max_problems;
    return take_over(file, run_in_child(allowance_for(static_cast<std::uint64_t>(status.st_size)),
                                        [&job](int descriptor) { import_into(descriptor, job); }));
}

} // namespace lightbench
