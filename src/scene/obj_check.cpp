// The line scanner of OBJ files.
#include "scene/obj_check.h"

#include "scene/import_text.h"
#include "scene/limits.h"

#include <algorithm>
#include <array>
#include <fmt/ranges.h>
#include <initializer_list>
#include <set>
#include <span>

namespace lightbench::importer {

namespace {

enum Kind : std::size_t { position, uv, normal, kKinds };
constexpr std::array<std::string_view, kKinds> kKindNames = {"vertex", "texture coordinate", "normal"};

// A face may use a vertex that follows it: seen once all of them are known.
struct Forward {
    Kind kind;
    long long index;
    unsigned line;
};

struct Scan {
    Report& report;
    unsigned line = 0;
    std::array<std::size_t, kKinds> count{};
    std::vector<Forward> forward;
    std::set<std::string, std::less<>> used;
    std::size_t points = 0, lines = 0, freeform = 0, unknown = 0;
    std::string first_unknown;
    ObjContents contents;
};

// Numbers are checked one by one; how many there may be depends on the keyword (`v` may carry a weight or a color).
void check_numbers(Scan& scan, std::string_view keyword, std::string_view rest, std::initializer_list<std::size_t> counts) {
    std::size_t count = 0;
    double last = 0;
    for (std::string_view word; !(word = next_word(rest)).empty() && word[0] != '#'; ++count) {
        const auto value = parse_number(word);
        if (!value) return scan.report.problem_at(scan.line, fmt::format("{}: {} is not a number", keyword, in_quotes(word)));
        if (!std::isfinite(*value)) return scan.report.problem_at(scan.line, fmt::format("{}: {} is not finite", keyword, in_quotes(word)));
        last = *value;
    }
    if (std::find(counts.begin(), counts.end(), count) == counts.end())
        scan.report.problem_at(scan.line, fmt::format("{} has {} numbers; it needs {}", keyword, count, fmt::join(counts, " or ")));
    else if (keyword == "v" && count == 4 && last == 0)
        scan.report.problem_at(scan.line, "v: the weight is 0, which is a point at infinity");
}

bool check_index(Scan& scan, Kind kind, std::string_view word) {
    const auto index = parse_integer(word);
    const auto known = static_cast<long long>(scan.count[kind]);
    if (!index)
        scan.report.problem_at(scan.line, fmt::format("{} is not a {} number", in_quotes(word), kKindNames[kind]));
    else if (*index == 0)
        scan.report.problem_at(scan.line, fmt::format("{} 0 does not exist; they count from 1", kKindNames[kind]));
    else if (*index < -known)
        scan.report.problem_at(scan.line, fmt::format("{} {} does not exist; {} precede this line", kKindNames[kind], *index, known));
    else if (*index > known)
        scan.forward.push_back({kind, *index, scan.line});
    return index && *index != 0 && *index >= -known;
}

// `1`, `1/2`, `1//3`, `1/2/3`: returns the bits of what is there, or nothing after a problem.
std::optional<unsigned> check_corner(Scan& scan, std::string_view corner) {
    unsigned present = 0;
    const std::string_view whole = corner;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        const std::size_t end = corner.find('/');
        const std::string_view word = corner.substr(0, end);
        if (word.empty() && kind == position) {
            scan.report.problem_at(scan.line, fmt::format("{} names no vertex", in_quotes(whole)));
            return {};
        }
        if (!word.empty()) {
            if (!check_index(scan, static_cast<Kind>(kind), word)) return {};
            present |= 1u << kind;
        }
        if (end == corner.npos) return present;
        corner.remove_prefix(end + 1);
    }
    scan.report.problem_at(scan.line, fmt::format("{} has more than three parts", in_quotes(whole)));
    return {};
}

void check_face(Scan& scan, std::string_view rest) {
    std::size_t corners = 0;
    unsigned first = 0;
    for (std::string_view word; !(word = next_word(rest)).empty() && word[0] != '#'; ++corners) {
        const auto present = check_corner(scan, word);
        if (!present) return;
        if (corners == 0) first = *present;
        if (*present != first)
            return scan.report.problem_at(scan.line, "f: its corners differ in what they have; each needs the same of v/vt/vn");
    }
    if (corners == 0) scan.report.problem_at(scan.line, "f is empty; a face needs at least 3 corners");
    if (corners > limits::kMaxPolygonPoints)
        scan.report.problem_at(scan.line, fmt::format("f has {} corners; the limit is {}", corners, limits::kMaxPolygonPoints));
    ++scan.contents.faces;
}

void use_material(Scan& scan, std::string_view name) {
    constexpr std::size_t kLongestName = 1000; // Assimp's strings end at 1023
    if (name.size() > kLongestName)
        return scan.report.problem_at(scan.line,
                                      fmt::format("usemtl: the name has {} characters; the limit is {}", name.size(), kLongestName));
    if (name.empty() || scan.used.contains(name)) return;
    scan.used.emplace(name);
    scan.contents.materials.push_back({std::string(name), scan.line});
}

bool one_of(std::string_view word, std::initializer_list<std::string_view> list) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

// What a line that is not geometry means; it may be nothing at all.
void note_other(Scan& scan, std::string_view keyword, std::string_view rest) {
    if (keyword == "mtllib") return scan.contents.libraries.push_back({std::string(trimmed(rest)), scan.line});
    if (one_of(keyword, {"o", "g", "s", "mg", "lod", "bevel", "c_interp", "d_interp", "usemap", "maplib", "shadow_obj", "trace_obj"}))
        return;
    if (one_of(keyword, {"vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end", "con",
                         "ctech", "stech"}))
        ++scan.freeform;
    else if (keyword == "p")
        ++scan.points;
    else if (keyword == "l")
        ++scan.lines;
    else if (scan.unknown++ == 0)
        scan.first_unknown = fmt::format("{} in line {}", in_quotes(keyword), scan.line);
}

// True if the line is one that Assimp shall read.
bool check_line(Scan& scan, std::string_view keyword, std::string_view rest) {
    if (keyword == "v")
        check_numbers(scan, keyword, rest, {3, 4, 6}), ++scan.count[position];
    else if (keyword == "vn")
        check_numbers(scan, keyword, rest, {3}), ++scan.count[normal];
    else if (keyword == "vt")
        check_numbers(scan, keyword, rest, {2, 3}), ++scan.count[uv];
    else if (keyword == "f" || keyword == "fo")
        check_face(scan, rest);
    else if (keyword == "usemtl")
        use_material(scan, trimmed(rest));
    else
        return note_other(scan, keyword, rest), false;
    return true;
}

// What Assimp shall see of a line: nothing of what is not geometry; of the rest one line with the keyword in its first column, without
// continuations, tabs and comments (a material's name may hold #).
void rewrite(std::span<char> line, const std::string& keyword, bool geometry) {
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line = line.first(line.size() - 1);
    if (!geometry) {
        std::fill(line.begin(), line.end(), ' ');
        line[0] = '#';
        return;
    }
    const std::string_view blanks = keyword == "usemtl" ? "\\\r\n" : "\\\r\n\t\v\f";
    std::replace_if(
        line.begin(), line.end(), [&](char c) { return blanks.find(c) != blanks.npos; }, ' ');
    if (keyword != "usemtl") std::fill(std::find(line.begin(), line.end(), '#'), line.end(), ' ');
    const auto indent = std::find_if(line.begin(), line.end(), [](char c) { return c != ' ' && c != '\t' && c != '\v' && c != '\f'; });
    std::fill_n(indent, keyword.size(), ' ');
    std::copy(keyword.begin(), keyword.end(), line.begin());
}

void finish(Scan& scan) {
    scan.contents.vertices = scan.count[position];
    for (const Forward& use : scan.forward)
        if (use.index > static_cast<long long>(scan.count[use.kind]))
            scan.report.problem_at(
                use.line, fmt::format("{} {} does not exist; the file has {}", kKindNames[use.kind], use.index, scan.count[use.kind]));
    std::stable_sort(scan.report.log.kept.begin(), scan.report.log.kept.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    const auto remark = [&scan](std::size_t count, std::string_view what) {
        if (count > 0) scan.report.remark(fmt::format("{} {}", count, what));
    };
    remark(scan.points, "lines of points are not drawn");
    remark(scan.lines, "lines of line segments are not drawn");
    remark(scan.freeform, "lines of free-form curves and surfaces are not drawn");
    remark(scan.unknown, fmt::format("lines have no meaning in OBJ and are skipped, first {}", scan.first_unknown));
    if (scan.contents.vertices == 0)
        scan.report.problem("has no vertices: a line \"v x y z\" each");
    else if (scan.contents.faces == 0)
        scan.report.problem("has no faces; points, lines and free-form surfaces are not drawn");
}

// A byte order mark is no part of the first line, and Assimp knows no line that ends in CR alone.
void normalise(std::string& text) {
    if (text.starts_with("\xEF\xBB\xBF")) std::fill_n(text.begin(), 3, ' ');
    for (std::size_t at = text.find('\r'); at != text.npos; at = text.find('\r', at + 1))
        if (at + 1 == text.size() || text[at + 1] != '\n') text[at] = '\n';
    text.push_back('\n');
}

} // namespace

ObjContents check_obj(std::string& text, Report& report) {
    normalise(text);
    Scan scan{report, 0, {}, {}, {}, 0, 0, 0, 0, {}, {}};
    LineReader lines;
    lines.rest = text, lines.joins = true;
    while (auto line = lines.next()) {
        scan.line = lines.line;
        if (line->find('\0') != line->npos) {
            report.problem_at(scan.line, "holds a zero byte; OBJ is text in ASCII or UTF-8");
            return scan.contents;
        }
        const std::string keyword(next_word(*line));
        if (keyword.empty()) continue;
        const bool geometry = keyword[0] != '#' && check_line(scan, keyword, *line);
        rewrite(std::span(text).subspan(lines.start, lines.bytes_taken - lines.start), keyword, geometry);
    }
    finish(scan);
    return scan.contents;
}

} // namespace lightbench::importer
