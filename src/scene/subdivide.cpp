// One level of refinement at a time; midpoints of edges and of pairs of normals are made once and found again by their two ends.
#include "scene/subdivide.h"

#include "scene/normals.h"
#include "scene/triangulate.h"

#include <algorithm>
#include <bit>

namespace lightbench {
namespace {

// From a pair of indices to the index made of it; open addressing, at most half full.
class PairTable {
  public:
    explicit PairTable(std::size_t pairs) : slots_(std::bit_ceil(2 * pairs + 2)) {}

    // The value kept for the pair, in either order; kNone is to be replaced by the caller.
    std::uint32_t& at(std::uint32_t a, std::uint32_t b) {
        const std::uint64_t key = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
        std::size_t i = (key * 0x9e3779b97f4a7c15u) >> 20; // Fibonacci hashing: Knuth, TAOCP 3, 6.4
        for (i &= slots_.size() - 1; slots_[i].key != kFree && slots_[i].key != key;) i = (i + 1) & (slots_.size() - 1);
        slots_[i].key = key;
        return slots_[i].value;
    }

  private:
    static constexpr std::uint64_t kFree = ~std::uint64_t{0};
    struct Slot {
        std::uint64_t key = kFree;
        std::uint32_t value = kNone;
    };
    std::vector<Slot> slots_;
};

class Splitter {
  public:
    Splitter(Faces& old, const std::vector<glm::dvec3>& of_faces)
        : old_(old), of_faces_(of_faces), points_(old.corners.size()), normals_(old.normals.empty() ? 0 : old.corners.size()) {}
    void run();
    Faces made;
    std::vector<glm::dvec3> made_normals;

  private:
    std::uint32_t middle_point(std::uint32_t a, std::uint32_t b);
    std::uint32_t mean_normal(std::span<const Corner> of, std::size_t face);
    Corner middle(const Corner& a, const Corner& b, std::size_t face);
    void emit(std::size_t face, std::initializer_list<Corner> loop);
    void split_triangle(std::size_t face, std::span<const Corner> loop);
    void split_about_center(std::size_t face, std::span<const Corner> loop);
    bool convex(std::size_t face);
    void split_in_triangles(std::size_t face);

    Faces& old_;
    const std::vector<glm::dvec3>& of_faces_;
    PairTable points_, normals_;
    std::vector<glm::dvec3> loop_points_;
    std::vector<CornerTriple> triangles_;
};

std::uint32_t Splitter::middle_point(std::uint32_t a, std::uint32_t b) {
    std::uint32_t& known = points_.at(a, b);
    if (known == kNone) {
        known = static_cast<std::uint32_t>(made.points.size());
        made.points.push_back(0.5 * made.points[a] + 0.5 * made.points[b]);
    }
    return known;
}

// Opposite normals have no mean; then the face's own stands in.
std::uint32_t Splitter::mean_normal(std::span<const Corner> of, std::size_t face) {
    glm::dvec3 sum(0);
    for (const Corner& c : of) sum += made.normals[c.normal];
    const double length = glm::length(sum);
    made.normals.push_back(length > 1e-9 * double(of.size()) ? sum / length : of_faces_[face]);
    return static_cast<std::uint32_t>(made.normals.size() - 1);
}

Corner Splitter::middle(const Corner& a, const Corner& b, std::size_t face) {
    const std::uint32_t point = middle_point(a.point, b.point);
    if (a.normal == b.normal) return {point, a.normal};
    std::uint32_t& known = normals_.at(a.normal, b.normal);
    const Corner ends[2] = {a, b};
    if (known == kNone) known = mean_normal(ends, face);
    return {point, known};
}

void Splitter::emit(std::size_t face, std::initializer_list<Corner> loop) {
    made.corners.insert(made.corners.end(), loop);
    made.close_face();
    if (!old_.materials.empty()) made.materials.push_back(old_.materials[face]);
    const glm::dvec3 normal = face_normal(made.points, made.loop(made.count() - 1));
    made_normals.push_back(normal == glm::dvec3(0) ? of_faces_[face] : normal);
}

void Splitter::split_triangle(std::size_t face, std::span<const Corner> loop) {
    const Corner ab = middle(loop[0], loop[1], face), bc = middle(loop[1], loop[2], face), ca = middle(loop[2], loop[0], face);
    emit(face, {loop[0], ab, ca});
    emit(face, {loop[1], bc, ab});
    emit(face, {loop[2], ca, bc});
    emit(face, {ab, bc, ca});
}

void Splitter::split_about_center(std::size_t face, std::span<const Corner> loop) {
    Corner center{static_cast<std::uint32_t>(made.points.size()), loop[0].normal};
    glm::dvec3 sum(0);
    for (const Corner& c : loop) sum += made.points[c.point];
    made.points.push_back(sum / double(loop.size()));
    if (std::any_of(loop.begin(), loop.end(), [&](const Corner& c) { return c.normal != loop[0].normal; }))
        center.normal = mean_normal(loop, face);
    for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
        const Corner before = middle(loop[(i + n - 1) % n], loop[i], face), after = middle(loop[i], loop[(i + 1) % n], face);
        emit(face, {loop[i], after, center, before});
    }
}

bool Splitter::convex(std::size_t face) {
    loop_points_.clear();
    for (const Corner& c : old_.loop(face)) loop_points_.push_back(made.points[c.point]);
    return strictly_convex(flatten(loop_points_, of_faces_[face]));
}

void Splitter::split_in_triangles(std::size_t face) {
    triangles_.clear();
    triangulate(flatten(loop_points_, of_faces_[face]), triangles_);
    const auto loop = old_.loop(face);
    for (const auto& t : triangles_) {
        const Corner corners[3] = {loop[t[0]], loop[t[1]], loop[t[2]]};
        split_triangle(face, corners);
    }
}

void Splitter::run() {
    made.points.swap(old_.points);
    made.normals.swap(old_.normals);
    for (std::size_t face = 0; face < old_.count(); ++face) {
        const auto loop = old_.loop(face);
        if (loop.size() == 3)
            split_triangle(face, loop);
        else if (convex(face))
            split_about_center(face, loop);
        else
            split_in_triangles(face);
    }
    made.anchor = old_.anchor;
}

} // namespace

void subdivide(Faces& faces, std::vector<glm::dvec3>& of_faces, unsigned levels) {
    for (unsigned level = 0; level < levels; ++level) {
        Splitter splitter(faces, of_faces);
        splitter.run();
        faces = std::move(splitter.made);
        of_faces = std::move(splitter.made_normals);
    }
}

} // namespace lightbench
