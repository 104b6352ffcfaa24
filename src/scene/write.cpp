// Chooses the format, gathers what it cannot express, puts the bytes on disk.
#include "scene/write.h"

#include "scene/limits.h"
#include "scene/write_parts.h"

#include <algorithm>
#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace lightbench {
namespace {

std::string lower_extension(const std::filesystem::path& file) {
    std::string e = file.extension().string();
    std::transform(e.begin(), e.end(), e.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return e;
}

[[noreturn]] void fail(const std::filesystem::path& file, int code) {
    throw std::system_error(code, std::generic_category(), fmt::format("cannot write {}", file.string()));
}

Problems write_toml(const Scene& scene, const std::filesystem::path& file, std::string_view comment) {
    WriteLog log{file.string(), {}};
    const std::string text = toml_text(scene, file, comment, log);
    if (text.size() > limits::kMaxTomlBytes)
        refuse(log, fmt::format("a scene of {} bytes", text.size()),
               fmt::format("a TOML file may have {} (limit kMaxTomlBytes); write .nff", limits::kMaxTomlBytes), "");
    if (!log.entries.empty()) return problems_of(log);
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const auto beside = mesh_file(scene, i, file);
        put_file(beside, mesh_bytes(scene.meshes[i], beside));
    }
    put_file(file, text); // last, so that a scene that is there is complete
    return {};
}

Problems write_nff(const Scene& scene, const std::filesystem::path& file, std::string_view comment) {
    WriteLog log{file.string(), {}};
    const std::string text = nff_text(scene, comment, log);
    if (log.entries.empty()) put_file(file, text);
    return problems_of(log);
}

Problems write_shape(const Scene& scene, const std::filesystem::path& file, std::string_view comment) {
    WriteLog log{file.string(), {}};
    const Mesh mesh = merged_mesh(scene, log);
    if (log.entries.empty()) put_file(file, lower_extension(file) == ".ply" ? ply_bytes(mesh) : obj_text(mesh, comment));
    return problems_of(log);
}

} // namespace

void refuse(WriteLog& log, std::string_view what, std::string_view instead, std::string_view where) {
    const auto same = [&](const WriteLog::Entry& e) { return e.what == what && e.instead == instead; };
    auto entry = std::find_if(log.entries.begin(), log.entries.end(), same);
    if (entry == log.entries.end()) entry = log.entries.insert(entry, {std::string(what), std::string(instead), std::string(where), 0});
    ++entry->count;
}

Problems problems_of(const WriteLog& log) {
    Problems problems;
    for (const WriteLog::Entry& e : log.entries) {
        const std::string more = e.count > 1 ? fmt::format(" and {} more", e.count - 1) : "";
        const std::string where = e.first.empty() ? "" : e.first + more + ": ";
        problems.push_back({log.file, 0, 0, fmt::format("{}{} cannot be written; {}", where, e.what, e.instead)});
    }
    return problems;
}

std::string comment_lines(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        out += fmt::format("# {}\n", text.substr(at, end - at));
        at = end + 1;
    }
    return out;
}

void put_file(const std::filesystem::path& file, std::string_view bytes) {
    std::filesystem::path beside = file;
    beside += fmt::format(".{}.part", getpid());
    errno = 0;
    std::ofstream out(beside, std::ios::binary);
    if (out) out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    std::error_code error(out ? 0 : (errno ? errno : EIO), std::generic_category());
    if (!error) std::filesystem::rename(beside, file, error);
    if (!error) return;
    std::error_code ignored; // the first error is the one to tell
    std::filesystem::remove(beside, ignored);
    fail(file, error.value());
}

std::string mesh_bytes(const Mesh& mesh, const std::filesystem::path& file) {
    return file.extension() == ".ply" ? ply_bytes(mesh) : obj_text(mesh, mesh.name);
}

Problems write_scene(const Scene& scene, const std::filesystem::path& file, std::string_view comment) {
    const std::string extension = lower_extension(file);
    if (extension == ".toml") return write_toml(scene, file, comment);
    if (extension == ".nff") return write_nff(scene, file, comment);
    if (extension == ".obj" || extension == ".ply") return write_shape(scene, file, comment);
    return {{file.string(), 0, 0,
             fmt::format("the extension \"{}\" names no format that can be written; it must be .toml, .nff, .obj or .ply", extension)}};
}

} // namespace lightbench
