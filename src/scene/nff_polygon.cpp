// Polygons and patches of NFF: real files hold repeated points, slivers without area and quadrangles that are not quite planar.
#include "scene/check_geometry.h"
#include "scene/nff_parts.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr NffField kPoint[] = {{"x"}, {"y"}, {"z"}, {"normal x"}, {"normal y"}, {"normal z"}};

// -1, 2^31, 2^63 and words are told, and nothing is reserved for them.
std::optional<std::size_t> read_count(NffLoad& load, std::string_view statement) {
    const std::string_view word = skip_to_word_in_line(load.in) ? peek_word(load.in) : std::string_view{};
    const unsigned line = load.in.line, column = word.empty() ? load.word_column : load.in.column();
    const auto count = word.empty() ? std::nullopt : take_number(load.in);
    const bool whole =
        count && *count >= 3 && *count <= limits::kMaxPolygonPoints && *count == static_cast<double>(static_cast<std::size_t>(*count));
    if (whole) return static_cast<std::size_t>(*count);
    fault_at(load, line, column, "{}: {} points; the number must lie between 3 and {} (limit kMaxPolygonPoints)", statement,
             word.empty() ? "no number of" : in_quotes(word), limits::kMaxPolygonPoints);
    return std::nullopt;
}

bool read_points(NffLoad& load, std::string_view statement, std::size_t count, bool with_normals, Polygon& out, bool& normals_fine) {
    double n[6] = {};
    bool fine = true;
    const std::size_t numbers = with_normals ? 6 : 3;
    for (std::size_t i = 0; i < count && fine; ++i) {
        fine = read_numbers(load, statement, std::span(kPoint, numbers), std::span(n, numbers));
        if (!fine) break;
        const glm::dvec3 normal(n[3], n[4], n[5]);
        if (!out.points.empty() && out.points.back() == glm::dvec3(n[0], n[1], n[2])) continue; // a repeated point adds nothing
        out.points.emplace_back(n[0], n[1], n[2]);
        if (!with_normals) continue;
        normals_fine &= glm::length(normal) > 0;
        out.normals.push_back(glm::vec3(normal / glm::length(normal)));
    }
    return fine;
}

void drop_repeated_end(Polygon& polygon) {
    while (polygon.points.size() > 1 && polygon.points.front() == polygon.points.back()) {
        polygon.points.pop_back();
        if (!polygon.normals.empty()) polygon.normals.pop_back();
    }
}

void count(NffCount& c, unsigned line) {
    if (c.count++ == 0) c.first_line = line;
}

Polygon corner(const Polygon& p, std::size_t i) {
    Polygon triangle;
    for (std::size_t k : {std::size_t{0}, i, i + 1}) {
        triangle.points.push_back(p.points[k]);
        if (!p.normals.empty()) triangle.normals.push_back(p.normals[k]);
    }
    return triangle;
}

void add_polygon(NffLoad& load, Polygon polygon, unsigned line) {
    if (has_no_area(polygon.points)) return count(load.without_area, line);
    if (planarity_of(polygon.points).planar()) return add_object(load, std::move(polygon));
    count(load.cut, line);
    for (std::size_t i = 1; i + 1 < polygon.points.size() && !load.stopped; ++i) {
        Polygon triangle = corner(polygon, i);
        if (!has_no_area(triangle.points)) add_object(load, std::move(triangle));
    }
}

} // namespace

bool read_polygon(NffLoad& load, bool with_normals) {
    const std::string_view statement = with_normals ? "pp" : "p";
    const unsigned line = load.in.line;
    const auto points = read_count(load, statement);
    Polygon polygon;
    bool normals_fine = true;
    if (!points || !read_points(load, statement, *points, with_normals, polygon, normals_fine)) return false;
    drop_repeated_end(polygon);
    if (!normals_fine) {
        polygon.normals.clear();
        count(load.without_normals, line);
    }
    add_polygon(load, std::move(polygon), line);
    return true;
}

} // namespace lightbench
