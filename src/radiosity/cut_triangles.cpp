// Bisection of longest edges, the longest of all first: then every triangle at an edge that is cut has it for its longest, the cut goes to
// its middle from the opposite corner, and the triangles meet corner to corner at any time. What cut.h says.
#include "radiosity/cut.h"

#include "scene/triangulate.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

namespace lightbench {
namespace {

struct Triangle {
    std::array<std::uint32_t, 3> p;
    std::uint32_t face, unit; // kNone: too large for a patch
};

class Bisector {
  public:
    Bisector(const BaseMesh& base, const CutSizes& sizes, Cutting& cutting)
        : base_(base), cutting_(cutting), longest_element_(square(sizes.element)), longest_patch_(square(sizes.patch)) {}
    void add_face(std::uint32_t f);
    void run();

  private:
    using Key = std::uint64_t; // the two points of an edge, lower first
    // What is cut first: the longest, of equals that with the lowest points.
    struct Waiting {
        double length; // squared
        Key key;
        bool operator<(const Waiting& o) const { return length != o.length ? length < o.length : key > o.key; }
    };

    // As in pieces_of: what rounding made longer is not cut for that.
    static double square(double size) { return size * size * (1 + 0x1p-39); }
    static Key key_of(std::uint32_t a, std::uint32_t b) { return (Key{std::min(a, b)} << 32) | std::max(a, b); }
    double length(std::uint32_t a, std::uint32_t b) const {
        const glm::dvec3 d = cutting_.points[std::max(a, b)] - cutting_.points[std::min(a, b)];
        return glm::dot(d, d);
    }
    double longest(const std::array<std::uint32_t, 3>& p) const {
        return std::max({length(p[0], p[1]), length(p[1], p[2]), length(p[2], p[0])});
    }
    std::uint32_t new_unit(std::uint32_t face);
    void triangulate_face(const BaseFace& face);
    void push(const Triangle& t);
    void link(std::uint32_t side);
    void replace(std::uint32_t old, std::uint32_t by);
    void expect_few() const;
    void halve(Key key);
    void halve_triangle(std::uint32_t side, std::uint32_t middle);

    const BaseMesh& base_;
    Cutting& cutting_;
    const double longest_element_, longest_patch_; // squared
    std::vector<Triangle> triangles_;
    // Side k of triangle t is 3 t + k, from its corner k to the next. All sides along an edge are in a list, whose head is found by the
    // edge.
    std::vector<std::uint32_t> next_, previous_;
    std::unordered_map<Key, std::uint32_t> heads_;
    std::priority_queue<Waiting> waiting_;
    std::vector<glm::dvec3> loop_;
    std::vector<CornerTriple> triples_;
};

std::uint32_t Bisector::new_unit(std::uint32_t face) {
    cutting_.units.push_back({face});
    return static_cast<std::uint32_t>(cutting_.units.size() - 1);
}

void Bisector::triangulate_face(const BaseFace& face) {
    triples_.clear();
    loop_.clear();
    for (const Corner& c : base_.loop(face)) loop_.push_back(base_.points[c.point]);
    if (face.hub == kNone) return triangulate(flatten(loop_, face.normal), triples_);
    for (std::uint32_t i = 0; i < face.count; ++i) triples_.push_back({kNone, i, (i + 1) % face.count});
}

void Bisector::add_face(std::uint32_t f) {
    const BaseFace& face = base_.faces[f];
    triangulate_face(face);
    const auto point = [&](std::uint32_t i) { return i == kNone ? face.hub : base_.loop(face)[i].point; };
    const std::size_t first = triangles_.size();
    bool small = true;
    for (const auto& t : triples_) {
        const std::array<std::uint32_t, 3> p{point(t[0]), point(t[1]), point(t[2])};
        if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
        push({p, f, kNone});
        small = small && longest(p) <= longest_patch_;
    }
    if (first == triangles_.size()) return;
    const std::uint32_t whole = small ? new_unit(f) : kNone;
    for (std::size_t t = first; t < triangles_.size(); ++t) {
        triangles_[t].unit = whole;
        if (!small && longest(triangles_[t].p) <= longest_patch_) triangles_[t].unit = new_unit(f);
    }
}

void Bisector::push(const Triangle& t) {
    const auto side = static_cast<std::uint32_t>(3 * triangles_.size());
    triangles_.push_back(t);
    count_sides(cutting_, base_.faces[t.face].two_sided ? 2 : 1);
    next_.resize(side + 3, kNone), previous_.resize(side + 3, kNone);
    for (std::uint32_t k = 0; k < 3; ++k) link(side + k);
}

void Bisector::link(std::uint32_t side) {
    const auto& p = triangles_[side / 3].p;
    const std::uint32_t a = p[side % 3], b = p[(side % 3 + 1) % 3];
    const Key key = key_of(a, b);
    const auto [known, fresh] = heads_.try_emplace(key, side);
    previous_[side] = kNone;
    next_[side] = fresh ? kNone : known->second;
    if (!fresh) previous_[known->second] = side, known->second = side;
    if (const double l = length(a, b); fresh && l > longest_element_) waiting_.push({l, key});
}

// A side that takes another's place along the same edge.
void Bisector::replace(std::uint32_t old, std::uint32_t by) {
    next_[by] = next_[old], previous_[by] = previous_[old];
    if (next_[by] != kNone) previous_[next_[by]] = by;
    if (previous_[by] != kNone) {
        next_[previous_[by]] = by;
        return;
    }
    const auto& p = triangles_[by / 3].p;
    heads_[key_of(p[by % 3], p[(by % 3 + 1) % 3])] = by;
}

// Triangle a b c, cut from c to the middle m of a b: a m c stays in its place, m b c is new.
void Bisector::halve_triangle(std::uint32_t side, std::uint32_t middle) {
    const auto fresh = static_cast<std::uint32_t>(triangles_.size());
    const std::uint32_t t = side / 3, k = side % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    const Triangle old = triangles_[t];
    count_sides(cutting_, base_.faces[old.face].two_sided ? 2 : 1);
    triangles_[t].p[k1] = middle;
    triangles_.push_back({{middle, old.p[k1], old.p[k2]}, old.face, old.unit});
    next_.resize(next_.size() + 3, kNone), previous_.resize(previous_.size() + 3, kNone);
    replace(3 * t + k1, 3 * fresh + 1);
    for (std::uint32_t s : {3 * t + k, 3 * t + k1, 3 * fresh, 3 * fresh + 2}) link(s);
    for (std::uint32_t half : {t, fresh})
        if (old.unit == kNone && longest(triangles_[half].p) <= longest_patch_) triangles_[half].unit = new_unit(old.face);
}

void Bisector::halve(Key key) {
    const auto a = static_cast<std::uint32_t>(key >> 32), b = static_cast<std::uint32_t>(key);
    const auto middle = static_cast<std::uint32_t>(cutting_.points.size());
    cutting_.points.push_back(0.5 * cutting_.points[a] + 0.5 * cutting_.points[b]);
    const auto found = heads_.find(key);
    std::uint32_t side = found->second;
    heads_.erase(found);
    while (side != kNone) {
        const std::uint32_t after = next_[side];
        halve_triangle(side, middle);
        side = after;
    }
}

// No triangle has more area than the equilateral one: what cannot be few enough is refused before it is cut.
void Bisector::expect_few() const {
    double sides = 0;
    for (const Triangle& t : triangles_) {
        const glm::dvec3 a = cutting_.points[t.p[0]];
        const double area = 0.5 * glm::length(glm::cross(cutting_.points[t.p[1]] - a, cutting_.points[t.p[2]] - a));
        sides += (base_.faces[t.face].two_sided ? 2 : 1) * area / (std::sqrt(3.0) / 4 * longest_element_);
    }
    Cutting least;
    count_sides(least, sides);
}

void Bisector::run() {
    expect_few();
    heads_.reserve(4 * triangles_.size());
    while (!waiting_.empty()) {
        const Key key = waiting_.top().key;
        waiting_.pop();
        halve(key);
    }
    for (Triangle& t : triangles_)
        if (t.unit == kNone) t.unit = new_unit(t.face); // where patches are smaller than elements
    for (const Triangle& t : triangles_) cutting_.pieces.push_back({{t.p[0], t.p[1], t.p[2], kNone}, t.face, t.unit});
}

} // namespace

void cut_triangles(const BaseMesh& base, const CutSizes& sizes, const std::vector<bool>& grid, Cutting& cutting) {
    Bisector bisector(base, sizes, cutting);
    for (std::uint32_t f = 0; f < base.faces.size(); ++f)
        if (!grid[f]) bisector.add_face(f);
    bisector.run();
}

} // namespace lightbench
