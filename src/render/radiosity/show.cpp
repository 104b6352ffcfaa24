#include "render/radiosity/show.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lightbench {
namespace {

// Distance along the ray, or infinity. Moeller and Trumbore 1997, "Fast, minimum storage ray-triangle intersection"; front sides only.
double meet(const glm::dvec3& o, const glm::dvec3& d, const glm::dvec3& v0, const glm::dvec3& v1, const glm::dvec3& v2) {
    const glm::dvec3 e1 = v1 - v0, e2 = v2 - v0, p = glm::cross(d, e2), s = o - v0, q = glm::cross(s, e1);
    const double det = glm::dot(e1, p), u = glm::dot(s, p), v = glm::dot(d, q);
    const bool inside = det > 0 && u >= 0 && v >= 0 && u + v <= det;
    const double t = inside ? glm::dot(e2, q) / det : 0;
    return inside && t > 0 ? t : std::numeric_limits<double>::infinity();
}

// Hue by the golden ratio: neighbours in number differ most.
glm::vec3 color_of(std::uint32_t number) {
    const double hue = std::fmod(number * 0.6180339887498949, 1.0) * 6;
    const auto channel = [&](double at) { return static_cast<float>(std::clamp(std::fabs(std::fmod(hue + at, 6.0) - 3) - 1, 0.0, 1.0)); };
    return 0.15f + 0.6f * glm::vec3(channel(0), channel(4), channel(2));
}

glm::vec3 heat(double share) {
    const auto x = static_cast<float>(3 * share);
    return glm::clamp(glm::vec3(x, x - 1, x - 2), 0.0f, 1.0f);
}

} // namespace

std::optional<std::uint32_t> element_at(const PatchMesh& mesh, const View& view, const glm::dvec2& pixel) {
    const glm::dvec3 o = mesh.frame.from_world(view.eye), d = view.direction_through(pixel);
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<std::uint32_t> found;
    for (std::uint32_t i = 0; i < mesh.elements.size(); ++i) {
        const auto& c = mesh.elements[i].corners;
        double t = meet(o, d, mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]);
        if (mesh.elements[i].size() == 4) t = std::min(t, meet(o, d, mesh.points[c[0]], mesh.points[c[2]], mesh.points[c[3]]));
        if (t < nearest) nearest = t, found = i;
    }
    return found;
}

std::vector<glm::vec3> patch_colors(const PatchMesh& mesh, std::optional<std::uint32_t> picked) {
    std::vector<glm::vec3> colors;
    for (std::uint32_t i = 0; i < mesh.elements.size(); ++i) {
        const Element& e = mesh.elements[i];
        const float shade = (i - mesh.patches[e.patch].first) % 2 == 0 ? 1.0f : 0.75f;
        colors.push_back(e.covered ? glm::vec3(0) : e.patch == picked ? glm::vec3(1) : shade * color_of(e.patch));
    }
    return colors;
}

std::vector<glm::vec3> form_factor_colors(const PatchMesh& mesh, std::span<const std::uint32_t> row, std::uint32_t patch) {
    constexpr double kDecades = 4;
    std::vector<double> received;
    for (std::size_t i = 0; i < mesh.elements.size(); ++i) received.push_back(row[i] / mesh.elements[i].area);
    const double most = received.empty() ? 0 : *std::ranges::max_element(received);
    std::vector<glm::vec3> colors;
    for (std::size_t i = 0; i < received.size(); ++i) {
        const double share = received[i] > 0 ? 1 + std::log10(received[i] / most) / kDecades : 0;
        colors.push_back(mesh.elements[i].patch == patch ? glm::vec3(0, 0.2f, 1) : heat(std::clamp(share, 0.0, 1.0)));
    }
    return colors;
}

ImageF unfold(std::span<const std::uint32_t> items, unsigned resolution, std::span<const glm::vec3> of_elements, glm::uvec2 size) {
    const unsigned n = resolution, half = n / 2;
    ImageF image{size.x, size.y, std::vector<float>(std::size_t{4} * size.x * size.y, 0.0f)};
    const double step = 2.0 * n / std::min(size.x, size.y); // items a pixel
    const auto item_at = [&](int x, int y) -> std::size_t { // of the cross, (0, 0) its lower left corner; the sides' horizons outermost
        const int h = static_cast<int>(half), m = static_cast<int>(n);
        const auto side = [&](int s, int row, int column) { return static_cast<std::size_t>(m * m + (s * h + row) * m + column); };
        const bool in_x = x >= h && x < h + m, in_y = y >= h && y < h + m;
        if (x < 0 || y < 0 || x >= 2 * m || y >= 2 * m) return items.size();
        if (in_x && in_y) return static_cast<std::size_t>((y - h) * m + x - h);
        if (in_y) return x >= h + m ? side(0, h - 1 - (x - h - m), y - h) : side(1, x, y - h);
        if (in_x) return y >= h + m ? side(2, h - 1 - (y - h - m), x - h) : side(3, y, x - h);
        return items.size();
    };
    for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x) {
            const glm::dvec2 at = (glm::dvec2(x + 0.5, size.y - y - 0.5) - 0.5 * glm::dvec2(size)) * step + double(n);
            const std::size_t item = item_at(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
            const bool seen = item < items.size() && items[item] < of_elements.size();
            const glm::vec3 color = seen ? of_elements[items[item]] : glm::vec3(0);
            float* pixel = &image.rgba[4 * (std::size_t{y} * size.x + x)];
            pixel[0] = color.r, pixel[1] = color.g, pixel[2] = color.b, pixel[3] = 1;
        }
    return image;
}

} // namespace lightbench
