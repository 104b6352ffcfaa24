// Opens glTF files: JSON, the chunks of GLB, buffers in files and data URIs.
#include "scene/gltf_document.h"

#include "scene/import_text.h"
#include "scene/limits.h"
#include "scene/paths.h"

#include <array>
#include <bit>
#include <cstring>
#include <set>

namespace lightbench::importer {

namespace {

std::uint32_t word_at(std::span<const std::uint8_t> bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

struct Chunks {
    std::string_view json;
    std::span<const std::uint8_t> binary;
};

// Section 4.4: a header of 12 bytes, then chunks with headers of 8; JSON first, binary second, others skipped.
std::optional<Chunks> split_glb(std::span<const std::uint8_t> file, Report& report) {
    constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
    const auto fail = [&report](std::string text) -> std::optional<Chunks> { return report.problem(std::move(text)), std::nullopt; };
    if (file.size() < 20) return fail("ends inside of its header");
    if (word_at(file, 4) != 2) return fail(fmt::format("is binary glTF of version {}; only 2 is read", word_at(file, 4)));
    if (word_at(file, 8) > file.size()) return fail(fmt::format("says that it has {} bytes; it has {}", word_at(file, 8), file.size()));
    file = file.first(word_at(file, 8));
    Chunks chunks;
    for (std::size_t at = 12; at + 8 <= file.size();) {
        const std::size_t size = word_at(file, at), kind = word_at(file, at + 4);
        if (size > file.size() - at - 8)
            return fail(fmt::format("its chunk at byte {} has {} bytes; {} are left", at, size, file.size() - at - 8));
        const auto content = file.subspan(at + 8, size);
        if (kind == kJson && at == 12) chunks.json = text_of(content);
        if (kind == kBinary && chunks.binary.empty()) chunks.binary = content;
        at += 8 + size;
    }
    if (chunks.json.empty()) return fail("its first chunk is not JSON");
    return chunks;
}

// The library's message without its own name, and the byte's line.
std::optional<Json> parse_json(std::string_view text, Report& report) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const std::string_view before = text.substr(0, error.byte > 0 ? error.byte - 1 : 0);
        const auto line = static_cast<unsigned>(std::count(before.begin(), before.end(), '\n')) + 1;
        const std::string_view what = error.what();
        const std::size_t colon = what.find(": ");
        report.problem_at(line, fmt::format("is no valid JSON: {}", clean_name(colon == what.npos ? what : what.substr(colon + 2))));
    } catch (const Json::exception& error) {
        report.problem(fmt::format("is no valid JSON: {}", clean_name(error.what())));
    }
    return {};
}

// Extensions without which geometry cannot be read, and those whose absence changes the look only.
void check_extensions(const GltfValue& root, Report& report) {
    static const std::set<std::string, std::less<>> kRead = {"KHR_lights_punctual",
                                                             "KHR_materials_ior",
                                                             "KHR_materials_transmission",
                                                             "KHR_materials_emissive_strength",
                                                             "KHR_materials_pbrSpecularGlossiness",
                                                             "KHR_texture_transform",
                                                             "KHR_mesh_quantization"};
    const auto each = [&](const char* key, const auto& found) {
        const GltfValue list = root.array(key);
        for (std::size_t i = 0; i < list.size(); ++i)
            if (const Json& name = (*list.json)[i]; !name.is_string())
                list.problem("must hold names");
            else if (!kRead.contains(name.get_ref<const std::string&>()))
                found(name.get<std::string>());
    };
    each("extensionsRequired", [&](const std::string& name) {
        if (!name.starts_with("KHR_materials_")) report.problem(fmt::format("needs the extension {}, which is not read", clean_name(name)));
    });
    each("extensionsUsed", [&](const std::string& name) { report.remark(fmt::format("the extension {} is not used", clean_name(name))); });
}

bool check_version(const GltfValue& root, Report& report) {
    const GltfValue asset = root.object("asset");
    const std::string version = asset.text("version");
    if (!asset && report.ok())
        report.problem("has no \"asset\": it is no glTF 2.0, which needs \"asset\": {\"version\": \"2.0\"}");
    else if (report.ok() && !version.starts_with("2."))
        report.problem(fmt::format("is glTF of version {}; only 2.0 is read", in_quotes(version)));
    return report.ok();
}

std::optional<std::string> load_buffer(ImportJob& job, const GltfValue& buffer, std::span<const std::uint8_t> binary, bool first) {
    const std::string uri = buffer.text("uri");
    if (uri.empty()) {
        if (first && !binary.empty()) return std::string(text_of(binary));
        buffer.problem("has no uri, and the file no binary chunk for it");
        return {};
    }
    if (uri.starts_with("data:")) return data_uri(uri, job.report, buffer.place);
    const Found found = find_named(job.around, file_uri(uri));
    if (found.reference == Reference::missing) buffer.problem(fmt::format("the file {} does not exist", in_quotes(uri)));
    if (found.reference == Reference::outside)
        buffer.problem(
            fmt::format("the file {} lies outside the scene's folder; move it into the folder or give --allow-outside", in_quotes(uri)));
    if (found.reference != Reference::found) return {};
    Bytes read = read_file(found.file, limits::kMaxFileBytes, "kMaxFileBytes");
    if (!read.text) return buffer.problem(fmt::format("the file {}: {}", in_quotes(uri), read.why)), std::nullopt;
    expect_more_input(job, read.text->size());
    return std::move(read.text);
}

void load_buffers(ImportJob& job, GltfDocument& document, std::span<const std::uint8_t> binary) {
    const GltfValue buffers = document.root().array("buffers");
    if (buffers.size() > limits::kMaxIncludes)
        return buffers.problem(fmt::format("are {}; the limit is {}", buffers.size(), limits::kMaxIncludes));
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const GltfValue buffer = buffers.item(i);
        auto bytes = buffer ? load_buffer(job, buffer, binary, i == 0) : std::nullopt;
        const std::uint64_t said = buffer.count("byteLength", 0);
        if (bytes && said > bytes->size()) buffer.problem(fmt::format("byteLength is {}; there are {} bytes", said, bytes->size()));
        document.buffers.push_back(bytes ? std::move(*bytes) : std::string());
    }
}

int hex_digit(char c) {
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

// RFC 4648, section 4; padding is not needed. Nothing if another character is in it.
std::optional<std::string> decode_base64(std::string_view text) {
    constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<int, 256> value{};
    value.fill(-1);
    for (std::size_t i = 0; i < kAlphabet.size(); ++i) value[static_cast<unsigned char>(kAlphabet[i])] = static_cast<int>(i);
    while (text.ends_with('=')) text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() * 3 / 4);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int digit = value[static_cast<unsigned char>(text[i])];
        if (digit < 0) return {};
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        if (i % 4 != 0) bytes.push_back(static_cast<char>(bits >> (6 - 2 * (i % 4))));
    }
    return bytes;
}

} // namespace

std::optional<std::string> data_uri(std::string_view uri, Report& report, const std::string& place) {
    const std::size_t comma = uri.find(',');
    if (comma != uri.npos && uri.substr(0, comma).ends_with(";base64"))
        if (auto bytes = decode_base64(uri.substr(comma + 1))) return bytes;
    report.problem(fmt::format("{}: its data URI is no valid base64", place));
    return {};
}

std::string file_uri(std::string_view uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool escape = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0;
        name += escape ? static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2])) : uri[i];
        if (escape) i += 2;
    }
    return name;
}

std::optional<GltfDocument> open_gltf(ImportJob& job) {
    Chunks chunks{job.bytes, {}};
    if (chunks.json.starts_with("glTF")) {
        const auto split = split_glb(bytes_of(job.bytes), job.report);
        if (!split) return {};
        chunks = *split;
    }
    auto json = parse_json(chunks.json, job.report);
    if (!json) return {};
    std::optional<GltfDocument> document(std::in_place);
    document->json = std::move(*json);
    document->report = &job.report;
    if (!document->json.is_object()) return job.report.problem("is JSON, but no glTF: its top is no object"), std::nullopt;
    if (!check_version(document->root(), job.report)) return {};
    check_extensions(document->root(), job.report);
    load_buffers(job, *document, chunks.binary);
    if (job.report.ok()) check_gltf_ranges(*document);
    if (!job.report.ok()) return {};
    return document;
}

} // namespace lightbench::importer
