// One level of refinement at a time; midpoints of edges, of pairs of normals and of texture points are made once and found again by their two ends.
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

// A corner of a face, with its texture point if the faces have such.
struct Place {
    Corner corner;
    std::uint32_t texture = kNone;
};

class Splitter {
  public:
    Splitter(Faces& old, const std::vector<glm::dvec3>& of_faces)
        : old_(old), of_faces_(of_faces), points_(old.corners.size()), normals_(old.normals.empty() ? 0 : old.corners.size()),
          textures_(old.corner_textures.size()) {}
    void run();
    Faces made;
    std::vector<glm::dvec3> made_normals;

  private:
    std::uint32_t middle_point(std::uint32_t a, std::uint32_t b);
    std::uint32_t mean_normal(std::span<const Place> of, std::size_t face);
    std::uint32_t mean_texture(std::span<const Place> of);
    std::uint32_t middle_texture(const Place& a, const Place& b);
    Place middle(const Place& a, const Place& b, std::size_t face);
    void take_loop(std::size_t face);
    void emit(std::size_t face, std::initializer_list<Place> loop);
    void split_triangle(std::size_t face, std::span<const Place> loop);
    void split_about_center(std::size_t face, std::span<const Place> loop);
    bool convex(std::size_t face);
    void split_in_triangles(std::size_t face);

    Faces& old_;
    const std::vector<glm::dvec3>& of_faces_;
    PairTable points_, normals_, textures_;
    std::vector<Place> loop_;
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
std::uint32_t Splitter::mean_normal(std::span<const Place> of, std::size_t face) {
    glm::dvec3 sum(0);
    for (const Place& p : of) sum += made.normals[p.corner.normal];
    const double length = glm::length(sum);
    made.normals.push_back(length > 1e-9 * double(of.size()) ? sum / length : of_faces_[face]);
    return static_cast<std::uint32_t>(made.normals.size() - 1);
}

// Tangents of opposite handedness cancel in w, and then count as not given.
std::uint32_t Splitter::mean_texture(std::span<const Place> of) {
    TexturePoint sum;
    for (const Place& p : of) sum.uv += made.texture_points[p.texture].uv, sum.tangent += made.texture_points[p.texture].tangent;
    made.texture_points.push_back({sum.uv / double(of.size()), sum.tangent / double(of.size())});
    return static_cast<std::uint32_t>(made.texture_points.size() - 1);
}

std::uint32_t Splitter::middle_texture(const Place& a, const Place& b) {
    if (a.texture == b.texture) return a.texture;
    std::uint32_t& known = textures_.at(a.texture, b.texture);
    const Place ends[2] = {a, b};
    if (known == kNone) known = mean_texture(ends);
    return known;
}

Place Splitter::middle(const Place& a, const Place& b, std::size_t face) {
    Place place{{middle_point(a.corner.point, b.corner.point), a.corner.normal}, middle_texture(a, b)};
    if (a.corner.normal == b.corner.normal) return place;
    std::uint32_t& known = normals_.at(a.corner.normal, b.corner.normal);
    const Place ends[2] = {a, b};
    if (known == kNone) known = mean_normal(ends, face);
    place.corner.normal = known;
    return place;
}

void Splitter::take_loop(std::size_t face) {
    const auto corners = old_.loop(face);
    const auto textures = old_.textures(face);
    loop_.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) loop_.push_back({corners[i], textures.empty() ? kNone : textures[i]});
}

void Splitter::emit(std::size_t face, std::initializer_list<Place> loop) {
    for (const Place& p : loop) {
        made.corners.push_back(p.corner);
        if (p.texture != kNone) made.corner_textures.push_back(p.texture);
    }
    made.close_face();
    if (!old_.materials.empty()) made.materials.push_back(old_.materials[face]);
    const glm::dvec3 normal = face_normal(made.points, made.loop(made.count() - 1));
    made_normals.push_back(normal == glm::dvec3(0) ? of_faces_[face] : normal);
}

void Splitter::split_triangle(std::size_t face, std::span<const Place> loop) {
    const Place ab = middle(loop[0], loop[1], face), bc = middle(loop[1], loop[2], face), ca = middle(loop[2], loop[0], face);
    emit(face, {loop[0], ab, ca});
    emit(face, {loop[1], bc, ab});
    emit(face, {loop[2], ca, bc});
    emit(face, {ab, bc, ca});
}

void Splitter::split_about_center(std::size_t face, std::span<const Place> loop) {
    Place center{{static_cast<std::uint32_t>(made.points.size()), loop[0].corner.normal}, kNone};
    glm::dvec3 sum(0);
    for (const Place& p : loop) sum += made.points[p.corner.point];
    made.points.push_back(sum / double(loop.size()));
    if (std::any_of(loop.begin(), loop.end(), [&](const Place& p) { return p.corner.normal != loop[0].corner.normal; }))
        center.corner.normal = mean_normal(loop, face);
    if (loop[0].texture != kNone) center.texture = mean_texture(loop);
    for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
        const Place before = middle(loop[(i + n - 1) % n], loop[i], face), after = middle(loop[i], loop[(i + 1) % n], face);
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
    for (const auto& t : triangles_) {
        const Place corners[3] = {loop_[t[0]], loop_[t[1]], loop_[t[2]]};
        split_triangle(face, corners);
    }
}

void Splitter::run() {
    made.points.swap(old_.points);
    made.normals.swap(old_.normals);
    made.texture_points.swap(old_.texture_points);
    for (std::size_t face = 0; face < old_.count(); ++face) {
        take_loop(face);
        if (loop_.size() == 3)
            split_triangle(face, loop_);
        else if (convex(face))
            split_about_center(face, loop_);
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
