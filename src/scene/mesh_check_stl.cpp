// Checks STL files, in text and in binary.
#include "scene/import_text.h"
#include "scene/mesh_check.h"

#include <bit>
#include <cstring>
#include <string_view>

namespace lightbench::importer {

namespace {

constexpr std::size_t kHeader = 84, kTriangle = 50;

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

std::size_t said_triangles(ByteView file) {
    std::uint32_t count = 0;
    if (file.size() >= kHeader) std::memcpy(&count, file.data() + 80, sizeof count);
    return count;
}

// Binary files may begin with "solid" too: the size decides first.
bool is_text(ByteView file) {
    if (file.size() >= kHeader && file.size() == kHeader + kTriangle * said_triangles(file)) return false;
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    return trimmed(text.substr(0, 256)).starts_with("solid") && text.substr(0, 1024).find('\0') == text.npos;
}

struct TextScan {
    Report& report;
    unsigned line = 0;
    bool in_facet = false, in_loop = false;
    std::size_t vertices = 0, facets = 0;

    void problem(std::string text) { report.problem_at(line, std::move(text)); }
};

void check_vertex(TextScan& scan, std::string_view rest) {
    std::size_t count = 0;
    for (std::string_view word; !(word = next_word(rest)).empty(); ++count)
        if (!parse_number(word)) return scan.problem(fmt::format("vertex: {} is not a number", in_quotes(word)));
    if (count != 3) scan.problem(fmt::format("vertex has {} numbers; it needs 3", count));
    if (!scan.in_loop) scan.problem("vertex outside of \"outer loop\"");
    ++scan.vertices;
}

void end_facet(TextScan& scan) {
    if (!scan.in_facet)
        scan.problem("endfacet without facet");
    else if (scan.vertices != 3)
        scan.problem(fmt::format("the facet that ends here has {} vertices; it needs 3", scan.vertices));
    scan.in_facet = scan.in_loop = false;
    ++scan.facets;
}

void check_line(TextScan& scan, std::string_view text) {
    const std::string_view keyword = next_word(text);
    if (keyword.empty() || keyword == "solid" || keyword == "endsolid" || keyword == "color") return;
    if (keyword == "vertex") return check_vertex(scan, text);
    if (keyword == "endfacet") return end_facet(scan);
    if (keyword == "facet") {
        if (scan.in_facet) scan.problem("facet inside of a facet; \"endfacet\" is missing");
        scan.in_facet = true, scan.vertices = 0;
    } else if (keyword == "outer")
        scan.in_loop = true;
    else if (keyword == "endloop")
        scan.in_loop = false;
    else
        scan.problem(fmt::format("{} has no meaning in STL", in_quotes(keyword)));
}

void check_text(ByteView file, Report& report) {
    TextScan scan{report};
    LineReader lines;
    lines.rest = {reinterpret_cast<const char*>(file.data()), file.size()};
    while (const auto line = lines.next()) {
        scan.line = lines.line;
        check_line(scan, *line);
    }
    if (scan.in_facet)
        scan.problem("ends inside of a facet; \"endfacet\" is missing");
    else if (scan.facets == 0)
        report.problem("has no facets");
}

} // namespace

ByteView check_stl(ByteView file, Report& report) {
    if (is_text(file)) return check_text(file, report), file;
    const std::size_t triangles = said_triangles(file), needed = kHeader + kTriangle * triangles;
    if (file.size() < kHeader)
        report.problem(fmt::format("is no STL: neither text that begins with \"solid\" nor a binary header of {} bytes (it has {})",
                                   kHeader, file.size()));
    else if (file.size() < needed)
        report.problem(fmt::format("says that it has {} triangles, which take {} bytes; it has {}", triangles, needed, file.size()));
    else if (triangles == 0)
        report.problem("has no triangles");
    else if (file.size() > needed)
        report.remark(fmt::format("{} bytes after the last triangle are not read", file.size() - needed));
    return report.ok() ? file.first(needed) : ByteView{};
}

} // namespace lightbench::importer
