// Ear clipping (Meisters 1975, "Polygons have ears") over a grid of the reflex corners, which alone can lie in an ear.
#include "scene/triangulate.h"

#include "scene/tessellate_faces.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace lightbench {
namespace {

using Ear = std::array<glm::dvec2, 3>;

// The corners that may block an ear, by cells of a grid over the loop: an ear asks only the cells that it covers, row by row.
class CornerGrid {
  public:
    CornerGrid(std::span<const glm::dvec2> loop, const std::vector<std::uint32_t>& corners);

    // Calls `blocks(corner)` for the corners in cells that the ear touches until it returns true; returns whether it did.
    template <typename Blocks> bool any_in(const Ear& ear, Blocks blocks) const {
        const Ear e{in_cells(ear[0]), in_cells(ear[1]), in_cells(ear[2])};
        const int last = cell(std::max({e[0].y, e[1].y, e[2].y}) + kSlack);
        for (int row = cell(std::min({e[0].y, e[1].y, e[2].y}) - kSlack); row <= last; ++row) {
            const glm::dvec2 reach = reach_in_row(e, row);
            for (int column = cell(reach.x - kSlack); column <= cell(reach.y + kSlack); ++column) {
                const std::size_t at = std::size_t(row) * std::size_t(side_) + std::size_t(column);
                for (std::uint32_t i = starts_[at]; i < starts_[at + 1]; ++i)
                    if (blocks(corners_[i])) return true;
            }
        }
        return false;
    }

  private:
    // Parts of a cell that an ear is taken to be wider by: far above the rounding of coordinates in cells, 2^-53 times 256 cells.
    static constexpr double kSlack = 1e-9;

    glm::dvec2 in_cells(const glm::dvec2& p) const { return (p - low_) * cells_per_unit_; }
    int cell(double x) const { return std::clamp(static_cast<int>(std::floor(x)), 0, side_ - 1); }
    std::size_t cell_of(const glm::dvec2& p) const {
        const glm::dvec2 c = in_cells(p);
        return std::size_t(cell(c.y)) * std::size_t(side_) + std::size_t(cell(c.x));
    }
    glm::dvec2 reach_in_row(const Ear& ear, int row) const;

    int side_;
    glm::dvec2 low_, cells_per_unit_;
    std::vector<std::uint32_t> starts_, corners_;
};

// From which x to which the ear covers the row; the first and last rows reach out to everything beyond the grid.
glm::dvec2 CornerGrid::reach_in_row(const Ear& ear, int row) const {
    const double low = row == 0 ? -1 : row - kSlack, high = row == side_ - 1 ? side_ + 1 : row + 1 + kSlack;
    glm::dvec2 reach(side_, 0);
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 &a = ear[i], &b = ear[(i + 1) % 3];
        if (std::max(a.y, b.y) < low || std::min(a.y, b.y) > high) continue;
        for (double y : {low, high}) {
            const double t = a.y == b.y ? 0 : std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0);
            const double x = a.x + t * (b.x - a.x);
            reach = {std::min(reach.x, x), std::max(reach.y, x)};
        }
        if (a.y == b.y) reach = {std::min(reach.x, b.x), std::max(reach.y, b.x)};
    }
    return reach;
}

CornerGrid::CornerGrid(std::span<const glm::dvec2> loop, const std::vector<std::uint32_t>& corners)
    : side_(1 + static_cast<int>(std::sqrt(double(corners.size())))), low_(loop[0]) {
    glm::dvec2 high = loop[0];
    for (const auto& p : loop) low_ = glm::min(low_, p), high = glm::max(high, p);
    cells_per_unit_ = double(side_) / glm::max(high - low_, glm::dvec2(1e-300));
    starts_.assign(std::size_t(side_) * std::size_t(side_) + 1, 0);
    for (std::uint32_t corner : corners) ++starts_[cell_of(loop[corner]) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    corners_.resize(corners.size());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t corner : corners) corners_[next[cell_of(loop[corner])]++] = corner;
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
    void queue(std::uint32_t corner);
    void queue_all(std::uint32_t from);

    struct Waiting {
        std::uint32_t corner, turn;
    };

    std::span<const glm::dvec2> loop_;
    std::vector<CornerTriple>& triangles_;
    std::vector<std::uint32_t> previous_, next_;
    std::vector<std::uint32_t> turn_; // the number of a corner's latest place in the queue; earlier ones count no more
    std::deque<Waiting> queue_;
    CornerGrid grid_;
};

EarClipper::EarClipper(std::span<const glm::dvec2> loop, std::vector<CornerTriple>& triangles)
    : loop_(loop), triangles_(triangles), previous_(loop.size()), next_(loop.size()), turn_(loop.size(), 0),
      grid_(loop, reflex_corners(loop)) {
    const auto n = static_cast<std::uint32_t>(loop.size());
    for (std::uint32_t i = 0; i < n; ++i) previous_[i] = (i + n - 1) % n, next_[i] = (i + 1) % n;
}

// Is a reflex corner inside the ear, or (by_touch) on its rim? Corners at the very place of one of the ear's own, as where a loop runs
// along a bridge to a hole and back, do not block.
bool EarClipper::blocked(std::uint32_t ear, bool by_touch) const {
    const glm::dvec2 a = loop_[previous_[ear]], b = loop_[ear], c = loop_[next_[ear]];
    return grid_.any_in({a, b, c}, [&](std::uint32_t i) {
        const glm::dvec2 p = loop_[i];
        if (next_[i] == kNone || p == a || p == b || p == c || area_at(i) > 0) return false;
        const double least = std::min({twice_area(a, b, p), twice_area(b, c, p), twice_area(c, a, p)});
        return by_touch ? least >= 0 : least > 0;
    });
}

bool EarClipper::is_ear(std::uint32_t i, Demand demand) const {
    if (demand == Demand::any) return true;
    const double area = area_at(i);
    if (demand == Demand::flat && area == 0) return true;
    return area > 0 && !blocked(i, demand == Demand::empty);
}

// A corner without area is let go without a triangle: only loops without any true ear come to that.
void EarClipper::clip(std::uint32_t ear) {
    const std::uint32_t a = previous_[ear], c = next_[ear];
    if (area_at(ear) != 0) triangles_.push_back({a, ear, c});
    next_[a] = c, previous_[c] = a;
    next_[ear] = kNone;
}

void EarClipper::queue(std::uint32_t corner) {
    queue_.push_back({corner, ++turn_[corner]});
}

// All corners that are left, in order.
void EarClipper::queue_all(std::uint32_t from) {
    std::uint32_t i = from;
    do queue(i), i = next_[i];
    while (i != from);
}

// Corners wait in a queue. Those beside a clipped ear have changed and go to its end, so that ears do not fan out from one corner into
// slivers, and a band that winds is eaten up from its ends. When the queue runs dry all that are left get another turn, since what blocked
// them may be gone; if that was of no use, less is asked of an ear. After such a lesser ear everything is asked again, kLesserEars times: a
// loop that touches itself needs few, and one that crosses itself everywhere is not to be gone through for every ear.
void EarClipper::run() {
    constexpr int kLesserEars = 64;
    std::size_t left = loop_.size();
    Demand demand = Demand::empty;
    std::uint32_t last = 0;
    int lesser_ears = 0;
    for (bool clipped = true; left > 3;) {
        if (queue_.empty()) {
            if (!clipped) demand = static_cast<Demand>(static_cast<int>(demand) + 1);
            clipped = false;
            queue_all(last);
        }
        const auto [corner, turn] = queue_.front();
        queue_.pop_front();
        if (next_[corner] == kNone || turn != turn_[corner] || !is_ear(corner, demand)) continue;
        last = next_[corner];
        clip(corner);
        --left, clipped = true;
        queue(previous_[last]);
        queue(last);
        if (demand == Demand::empty || ++lesser_ears > kLesserEars) continue;
        queue_.clear();
        demand = Demand::empty;
    }
    if (area_at(last) != 0) triangles_.push_back({previous_[last], last, next_[last]});
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
