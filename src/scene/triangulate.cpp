// Ear clipping (Meisters 1975, "Polygons have ears") over a grid of the reflex corners, which alone can lie in an ear.
#include "scene/triangulate.h"

#include "scene/tessellate_faces.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

// The corners that may block an ear, by cells of a grid over the loop: an ear asks only the cells that it covers.
class CornerGrid {
  public:
    CornerGrid(std::span<const glm::dvec2> loop, const std::vector<std::uint32_t>& corners);

    // Calls `blocks(corner)` for corners near the box until it returns true; returns whether it did.
    template <typename Blocks> bool any_in(const glm::dvec2& low, const glm::dvec2& high, Blocks blocks) const {
        const glm::ivec2 from = cell_of(low), to = cell_of(high);
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x) {
                const std::size_t cell = std::size_t(y) * std::size_t(side_) + std::size_t(x);
                for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i)
                    if (blocks(corners_[i])) return true;
            }
        return false;
    }

  private:
    glm::ivec2 cell_of(const glm::dvec2& p) const {
        return glm::clamp(glm::ivec2((p - low_) * cells_per_unit_), glm::ivec2(0), glm::ivec2(side_ - 1));
    }

    int side_;
    glm::dvec2 low_, cells_per_unit_;
    std::vector<std::uint32_t> starts_, corners_;
};

CornerGrid::CornerGrid(std::span<const glm::dvec2> loop, const std::vector<std::uint32_t>& corners)
    : side_(1 + static_cast<int>(std::sqrt(double(corners.size())))), low_(loop[0]) {
    glm::dvec2 high = loop[0];
    for (const auto& p : loop) low_ = glm::min(low_, p), high = glm::max(high, p);
    cells_per_unit_ = double(side_) / glm::max(high - low_, glm::dvec2(1e-300));
    starts_.assign(std::size_t(side_) * std::size_t(side_) + 1, 0);
    const auto cell = [&](std::uint32_t corner) {
        const glm::ivec2 c = cell_of(loop[corner]);
        return std::size_t(c.y) * std::size_t(side_) + std::size_t(c.x);
    };
    for (std::uint32_t corner : corners) ++starts_[cell(corner) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    corners_.resize(corners.size());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t corner : corners) corners_[next[cell(corner)]++] = corner;
}

std::vector<std::uint32_t> reflex_corners(std::span<const glm::dvec2> loop) {
    std::vector<std::uint32_t> reflex;
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i)
        if (!(twice_area(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]) > 0)) reflex.push_back(static_cast<std::uint32_t>(i));
    return reflex;
}

// How much is asked of an ear. The later ones are for loops that touch or cross themselves, where no true ear may be left.
enum class Demand { empty, empty_inside, flat, any };

class EarClipper {
  public:
    EarClipper(std::span<const glm::dvec2> loop, std::vector<CornerTriple>& triangles);
    void run();

  private:
    double area_at(std::uint32_t i) const { return twice_area(loop_[previous_[i]], loop_[i], loop_[next_[i]]); }
    bool blocked(std::uint32_t ear, bool by_touch) const;
    bool is_ear(std::uint32_t i, Demand demand) const;
    void clip(std::uint32_t ear);

    std::span<const glm::dvec2> loop_;
    std::vector<CornerTriple>& triangles_;
    std::vector<std::uint32_t> previous_, next_;
    CornerGrid grid_;
};

EarClipper::EarClipper(std::span<const glm::dvec2> loop, std::vector<CornerTriple>& triangles)
    : loop_(loop), triangles_(triangles), previous_(loop.size()), next_(loop.size()), grid_(loop, reflex_corners(loop)) {
    const auto n = static_cast<std::uint32_t>(loop.size());
    for (std::uint32_t i = 0; i < n; ++i) previous_[i] = (i + n - 1) % n, next_[i] = (i + 1) % n;
}

// Is a reflex corner inside the ear, or (by_touch) on its rim? Corners at the very place of one of the ear's own, as where a loop runs
// along a bridge to a hole and back, do not block.
bool EarClipper::blocked(std::uint32_t ear, bool by_touch) const {
    const glm::dvec2 a = loop_[previous_[ear]], b = loop_[ear], c = loop_[next_[ear]];
    return grid_.any_in(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), [&](std::uint32_t i) {
        const glm::dvec2 p = loop_[i];
        if (next_[i] == kNone || p == a || p == b || p == c || area_at(i) > 0) return false;
        const double least = std::min({twice_area(a, b, p), twice_area(b, c, p), twice_area(c, a, p)});
        return by_touch ? least >= 0 : least > 0;
    });
}

bool EarClipper::is_ear(std::uint32_t i, Demand demand) const {
    if (demand == Demand::any) return true;
    const double area = area_at(i);
    if (demand == Demand::flat) return area == 0;
    return area > 0 && !blocked(i, demand == Demand::empty);
}

// A corner without area is let go without a triangle: only loops without any true ear come to that.
void EarClipper::clip(std::uint32_t ear) {
    const std::uint32_t a = previous_[ear], c = next_[ear];
    if (area_at(ear) != 0) triangles_.push_back({a, ear, c});
    next_[a] = c, previous_[c] = a;
    next_[ear] = kNone;
}

// Goes round and round; after a round without an ear the demand falls by one, after an ear it is the strictest again. Every second corner
// is passed over, so that ears do not fan out from one corner into slivers.
void EarClipper::run() {
    std::size_t left = loop_.size(), misses = 0;
    Demand demand = Demand::empty;
    std::uint32_t i = 0;
    while (left > 3) {
        const std::uint32_t after = next_[i];
        if (is_ear(i, demand)) {
            clip(i);
            --left, misses = 0, demand = Demand::empty;
            i = next_[after];
            continue;
        }
        i = after;
        if (++misses < left) continue;
        misses = 0, demand = static_cast<Demand>(static_cast<int>(demand) + 1);
    }
    if (area_at(i) != 0) triangles_.push_back({previous_[i], i, next_[i]});
}

} // namespace

std::vector<glm::dvec2> flatten(std::span<const glm::dvec3> loop, const glm::dvec3& normal) {
    const glm::dvec3 size = glm::abs(normal);
    const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    int u = (drop + 1) % 3, v = (drop + 2) % 3;
    if (normal[drop] < 0) std::swap(u, v);
    std::vector<glm::dvec2> flat;
    flat.reserve(loop.size());
    for (const auto& p : loop) flat.emplace_back(p[u], p[v]);
    return flat;
}

double twice_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool strictly_convex(std::span<const glm::dvec2> loop) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i)
        if (!(twice_area(loop[i], loop[(i + 1) % n], loop[(i + 2) % n]) > 0)) return false;
    for (std::size_t i = 2; i + 1 < n; ++i) // a loop that winds twice turns left everywhere, but not seen from its first corner
        if (!(twice_area(loop[0], loop[i], loop[i + 1]) > 0)) return false;
    return true;
}

void triangulate(std::span<const glm::dvec2> loop, std::vector<CornerTriple>& triangles) {
    const auto n = static_cast<std::uint32_t>(loop.size());
    if (n == 3 || strictly_convex(loop)) {
        for (std::uint32_t i = 1; i + 1 < n; ++i) triangles.push_back({0, i, i + 1});
        return;
    }
    EarClipper(loop, triangles).run();
}

} // namespace lightbench
