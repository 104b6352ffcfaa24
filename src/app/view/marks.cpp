#include "app/view/marks.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lightbench::view {
namespace {

constexpr std::array<std::uint8_t, 3> kEdge = {255, 200, 60}, kNormal = {90, 220, 255};
constexpr std::size_t kMostNormals = 2500;

void blend(Image8& image, int x, int y, const std::array<std::uint8_t, 3>& color) {
    if (x < 0 || y < 0 || x >= int(image.width) || y >= int(image.height)) return;
    std::uint8_t* p = image.at(unsigned(x), unsigned(y));
    for (std::size_t i = 0; i < 3; ++i) p[i] = static_cast<std::uint8_t>((p[i] + 2 * color[i]) / 3);
}

// Cuts the segment to the picture (Liang and Barsky 1984), so that steps are counted inside of it only. False: nothing is left.
bool clip(const Image8& image, glm::dvec2& a, glm::dvec2& b) {
    double from = 0, to = 1;
    const glm::dvec2 d = b - a, high(image.width, image.height);
    for (int axis = 0; axis < 2; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const double p = side * d[axis], q = side < 0 ? a[axis] : high[axis] - a[axis];
            if (p == 0 && q < 0) return false;
            if (p < 0) from = std::max(from, q / p);
            if (p > 0) to = std::min(to, q / p);
        }
    if (from > to) return false;
    const glm::dvec2 start = a;
    a = start + d * from, b = start + d * to;
    return true;
}

void line(Image8& image, glm::dvec2 a, glm::dvec2 b, const std::array<std::uint8_t, 3>& color) {
    if (!clip(image, a, b)) return;
    const int steps = std::max(1, static_cast<int>(std::ceil(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)))));
    for (int i = 0; i <= steps; ++i) {
        const glm::dvec2 p = a + (b - a) * (double(i) / steps);
        blend(image, static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)), color);
    }
}

// Points of the frame of a geometry in pixels of a shot's picture, which may be coarser than the view says.
struct Projector {
    const View& view;
    const Frame& frame;
    glm::dvec2 scale, offset;
    std::optional<glm::dvec2> operator()(const glm::vec3& p) const {
        const auto pixel = pixel_of(view, frame.origin + glm::dvec3(p) / frame.scale);
        return pixel ? std::optional(*pixel * scale - offset) : std::nullopt;
    }
};

void draw_edges(Image8& image, const RasterGeometry& g, const Projector& to_pixel) {
    std::vector<std::optional<glm::dvec2>> points;
    for (const auto& p : g.vertices.positions) points.push_back(to_pixel(p.position));
    std::set<std::pair<std::uint32_t, std::uint32_t>> drawn;
    const auto edge = [&](std::uint32_t a, std::uint32_t b) {
        if (points[a] && points[b] && drawn.insert(std::minmax(a, b)).second) line(image, *points[a], *points[b], kEdge);
    };
    for (std::size_t c = 0; c < g.clusters.size(); ++c)
        for (std::uint32_t i = 0; i < g.clusters[c].index_count; i += 3) {
            const std::uint32_t* v = &g.indices[g.clusters[c].first_index + i];
            if (!points[v[0]] || !points[v[1]] || !points[v[2]]) continue;
            const glm::dvec2 u = *points[v[1]] - *points[v[0]], w = *points[v[2]] - *points[v[0]];
            if (!g.clusters[c].two_sided && u.x * w.y - u.y * w.x > 0) continue; // clockwise as y points down: its back
            for (int k = 0; k < 3; ++k) edge(v[k], v[(k + 1) % 3]);
        }
}

void draw_normals(Image8& image, const RasterGeometry& g, const Projector& to_pixel) {
    const std::size_t n = std::min(g.vertices.positions.size(), g.vertices.normals.size());
    const std::size_t step = (n + kMostNormals - 1) / kMostNormals;
    const float length = 0.02f * static_cast<float>(g.frame.radius);
    for (std::size_t i = 0; i < n; i += std::max<std::size_t>(step, 1)) {
        const glm::vec3 p = g.vertices.positions[i].position;
        const auto a = to_pixel(p), b = to_pixel(p + length * g.vertices.normals[i].normal);
        if (a && b) line(image, *a, *b, kNormal);
    }
}

} // namespace

std::optional<glm::dvec2> pixel_of(const View& view, const glm::dvec3& world) {
    const glm::dvec4 clip = view.clip_from_view * (view.view_from_world * glm::dvec4(world, 1));
    if (clip.w <= view.near) return std::nullopt;
    return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(view.size);
}

void mark(Shot& shot, const Scene& scene, bool wireframe, bool normals) {
    Scene copy = scene;
    Request request = shot.request;
    request.method = Method::raster, request.shading = Shading::phong, request.placed = shot.request.placed;
    const Prepared prepared = prepare(copy, request);
    auto marked = std::make_shared<Image8>(*shot.pixels);
    const Rect part = request.crop.value_or(Rect{{0, 0}, prepared.view.size});
    const glm::dvec2 scale = glm::dvec2(marked->width, marked->height) / glm::dvec2(part.size), offset = glm::dvec2(part.offset) * scale;
    const Projector to_pixel{prepared.view, prepared.geometry.frame, scale, offset};
    if (wireframe) draw_edges(*marked, prepared.geometry, to_pixel);
    if (normals) draw_normals(*marked, prepared.geometry, to_pixel);
    shot.marked = std::move(marked);
}

} // namespace lightbench::view
