// What the header of the same name says.
#include "radiosity/covered.h"

#include "scene/surfaces.h"
#include "scene/triangulate.h"

#include <algorithm>
#include <numeric>

namespace lightbench {
namespace {

// Frame units. Hemi-cubes see points as float32: coordinates below 2 move by 2^-24 at most, so two points that are one may lie 2 sqrt(3)
// 2^-24 apart, and what is nearer to each other than that is not told apart.
constexpr double kTouch = 0x1p-22;
constexpr double kOpposite = 0x1p-20; // of unit normals: by which a face as large as a quarter of the scene leaves the plane by kTouch

using Segment = std::array<glm::dvec3, 2>;

// A part of a plane that can cover: a face, or the bottom that a solid lacks.
struct Lid {
    glm::dvec3 origin{0}, normal{0};
    std::uint32_t face = kNone;         // that it is
    std::uint32_t first = 0, count = 0; // of segments around it, in any order
    Bounds box;
};

// Crossings of a ray in the plane, which starts at the point: odd inside (Shimrat 1962, "Algorithm 112: Position of point relative to
// polygon").
bool is_within(std::span<const Segment> outline, const glm::dvec3& point, const glm::dvec3& normal) {
    bool inside = false;
    for (const Segment& s : outline) {
        const std::array<glm::dvec3, 3> corners{s[0], s[1], point};
        const auto flat = flatten(corners, normal);
        if ((flat[0].y > flat[2].y) == (flat[1].y > flat[2].y)) continue;
        const bool up = flat[1].y > flat[0].y;
        if ((twice_area(flat[0], flat[1], flat[2]) > 0) == up) inside = !inside;
    }
    return inside;
}

// Lids by place: boxes, halved along their longest side.
class LidTree {
  public:
    explicit LidTree(const std::vector<Lid>& lids) : lids_(lids), order_(lids.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        if (!lids.empty()) build(0, static_cast<std::uint32_t>(lids.size()));
    }
    // Calls found(lid) for those whose box holds the point, until it says true; returns whether it did.
    template <typename Found> bool any_at(const glm::dvec3& p, Found found, std::uint32_t node = 0) const {
        if (nodes_.empty() || !holds(nodes_[node].box, p)) return false;
        const Node& n = nodes_[node];
        if (n.right != kNone) return any_at(p, found, node + 1) || any_at(p, found, n.right);
        for (std::uint32_t i = n.first; i < n.last; ++i)
            if (holds(lids_[order_[i]].box, p) && found(lids_[order_[i]])) return true;
        return false;
    }

  private:
    struct Node {
        Bounds box;
        std::uint32_t first, last, right; // kNone: a leaf
    };
    static bool holds(const Bounds& box, const glm::dvec3& p) {
        return glm::all(glm::lessThanEqual(box.min - kTouch, p)) && glm::all(glm::lessThanEqual(p, box.max + kTouch));
    }
    void build(std::uint32_t first, std::uint32_t last);

    const std::vector<Lid>& lids_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

void LidTree::build(std::uint32_t first, std::uint32_t last) {
    constexpr std::uint32_t kLeaf = 4;
    const std::size_t node = nodes_.size();
    nodes_.push_back({{}, first, last, kNone});
    for (std::uint32_t i = first; i < last; ++i) {
        nodes_[node].box.add(lids_[order_[i]].box.min);
        nodes_[node].box.add(lids_[order_[i]].box.max);
    }
    if (last - first <= kLeaf) return;
    const glm::dvec3 size = nodes_[node].box.max - nodes_[node].box.min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto place = [&](std::uint32_t lid) { return lids_[lid].box.min[axis] + lids_[lid].box.max[axis]; };
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    build(first, middle);
    nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
    build(middle, last);
}

// Faces that hang together over edges.
struct Part {
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> open; // corners that start edges of one face only
    bool opaque = true, dark = true;
};

class LidFinder {
  public:
    LidFinder(const Scene& scene, const BaseMesh& base, const BaseEdges& edges)
        : solid(base.faces.size()), scene_(scene), base_(base), edges_(edges) {}
    void run();
    std::vector<Lid> lids; // of the faces, one each; then the bottoms
    std::vector<Segment> segments;
    std::vector<bool> solid; // a face that bounds a solid, which is behind it

  private:
    const glm::dvec3& point(std::uint32_t corner) const { return base_.points[base_.corners[corner].point]; }
    const Material& material(const BaseFace& face) const { return scene_.materials[base_.surfaces[face.surface].material]; }
    void add(Lid lid, std::span<const std::uint32_t> corners);
    void add_faces();
    void find_parts();
    bool holds_lamp(const Part& part) const;
    double volume(const Part& part) const;
    bool stands_on(const Part& part, const glm::dvec3& up) const;
    void add_bottom(const Part& part);

    const Scene& scene_;
    const BaseMesh& base_;
    const BaseEdges& edges_;
    std::vector<Part> parts_; // by their first faces; the others are empty
    std::vector<glm::dvec3> lamps_;
};

void LidFinder::add(Lid lid, std::span<const std::uint32_t> corners) {
    lid.first = static_cast<std::uint32_t>(segments.size()), lid.count = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t c : corners) {
        segments.push_back({point(c), point(next_corner(base_, edges_, c))});
        lid.box.add(segments.back()[0]);
    }
    lids.push_back(lid);
}

void LidFinder::add_faces() {
    std::vector<std::uint32_t> corners;
    for (std::uint32_t f = 0; f < base_.faces.size(); ++f) {
        corners.resize(base_.faces[f].count);
        std::iota(corners.begin(), corners.end(), base_.faces[f].first);
        Lid lid;
        lid.origin = point(corners[0]), lid.normal = base_.faces[f].normal, lid.face = f;
        add(lid, corners);
    }
}

void LidFinder::find_parts() {
    std::vector<std::uint32_t> parent(base_.faces.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto face = [&](std::uint32_t corner) { return edges_.face_of_corner[corner]; };
    for (std::uint32_t e = 0; e < edges_.count(); ++e)
        for (std::uint32_t c : edges_.users_of(e)) parent[root_of(parent, face(c))] = root_of(parent, face(edges_.users_of(e)[0]));
    parts_.resize(base_.faces.size());
    for (std::uint32_t f = 0; f < base_.faces.size(); ++f) {
        Part& part = parts_[root_of(parent, f)];
        const Material& of = material(base_.faces[f]);
        part.faces.push_back(f);
        part.opaque = part.opaque && !is_translucent(of);
        part.dark = part.dark && of.emission == glm::vec3(0);
        if (of.emission != glm::vec3(0)) lamps_.push_back(point(base_.faces[f].first));
    }
    for (std::uint32_t e = 0; e < edges_.count(); ++e)
        if (const auto users = edges_.users_of(e); users.size() == 1) parts_[root_of(parent, face(users[0]))].open.push_back(users[0]);
    for (const Light& light : scene_.lights)
        if (light.type != LightType::directional) lamps_.push_back(base_.frame.from_world(light.position));
}

bool LidFinder::holds_lamp(const Part& part) const {
    Bounds box;
    for (std::uint32_t f : part.faces)
        for (const Corner& c : base_.loop(base_.faces[f])) box.add(base_.points[c.point]);
    return std::any_of(lamps_.begin(), lamps_.end(),
                       [&](const glm::dvec3& p) { return glm::all(glm::lessThan(box.min, p)) && glm::all(glm::lessThan(p, box.max)); });
}

// Six times it, by the divergence theorem.
double LidFinder::volume(const Part& part) const {
    const glm::dvec3 origin = point(base_.faces[part.faces[0]].first);
    double six = 0;
    for (std::uint32_t f : part.faces) {
        const auto loop = base_.loop(base_.faces[f]);
        const glm::dvec3 a = base_.points[loop[0].point] - origin;
        for (std::size_t i = 2; i < loop.size(); ++i)
            six += glm::dot(a, glm::cross(base_.points[loop[i - 1].point] - origin, base_.points[loop[i].point] - origin));
    }
    return six;
}

// Do all open edges lie in one plane, and everything else above it?
bool LidFinder::stands_on(const Part& part, const glm::dvec3& up) const {
    const glm::dvec3 origin = point(part.open[0]);
    const auto height = [&](std::uint32_t c) { return glm::dot(point(c) - origin, up); };
    if (std::any_of(part.open.begin(), part.open.end(), [&](std::uint32_t c) { return std::abs(height(c)) > kTouch; })) return false;
    double highest = 0;
    for (std::uint32_t f : part.faces)
        for (std::uint32_t c = base_.faces[f].first; c < base_.faces[f].first + base_.faces[f].count; ++c) {
            if (height(c) < -kTouch) return false;
            highest = std::max(highest, height(c));
        }
    return highest > kTouch;
}

// Open edges run as their faces do: where these look outwards, counter-clockwise as seen from inside the solid.
void LidFinder::add_bottom(const Part& part) {
    if (!part.opaque || !part.dark || part.open.size() < 3) return;
    const glm::dvec3 origin = point(part.open[0]);
    glm::dvec3 sum(0);
    for (std::uint32_t c : part.open) sum += glm::cross(point(c) - origin, point(next_corner(base_, edges_, c)) - origin);
    if (sum == glm::dvec3(0)) return;
    const glm::dvec3 up = glm::normalize(sum);
    if (!stands_on(part, up) || holds_lamp(part)) return;
    Lid lid;
    lid.origin = origin, lid.normal = -up;
    add(lid, part.open);
}

void LidFinder::run() {
    add_faces();
    find_parts();
    for (const Part& part : parts_) {
        if (part.faces.empty()) continue;
        if (!part.open.empty())
            add_bottom(part);
        else if (part.opaque && volume(part) > 0)
            for (std::uint32_t f : part.faces) solid[f] = true;
    }
}

} // namespace

void mark_covered(const Scene& scene, const BaseMesh& base, const BaseEdges& edges, const std::vector<std::uint32_t>& face_of_element,
                  PatchMesh& mesh) {
    LidFinder finder(scene, base, edges);
    finder.run();
    const LidTree tree(finder.lids);
    for (std::uint32_t e = 0; e < mesh.elements.size(); ++e) {
        Element& element = mesh.elements[e];
        if (element.behind < e) continue; // a back
        const glm::dvec3 front = base.faces[face_of_element[e]].normal;
        element.covered = tree.any_at(element.center, [&](const Lid& lid) {
            if (lid.face != kNone && !finder.solid[lid.face] && !finder.solid[face_of_element[e]]) return false;
            return glm::length(lid.normal + front) <= kOpposite && std::abs(glm::dot(element.center - lid.origin, lid.normal)) <= kTouch &&
                   is_within({finder.segments.data() + lid.first, lid.count}, element.center, lid.normal);
        });
    }
}

} // namespace lightbench
