// Sizes, elements and patches from what is cut. What the header of the same name says.
#include "radiosity/patches.h"

#include "radiosity/covered.h"
#include "radiosity/cut.h"
#include "radiosity/patch_units.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace lightbench {
namespace {

constexpr double kElementsAcross = 4; // of a patch, unless its size is given: 16 elements

// Of a piece that is a face's own side: corners, center, normal and area.
Element element_of(const std::vector<glm::dvec3>& points, const std::array<std::uint32_t, 4>& corners) {
    Element element;
    element.corners = corners;
    const glm::dvec3 a = points[corners[0]], b = points[corners[1]] - a, c = points[corners[2]] - a;
    const glm::dvec3 d = element.size() == 4 ? points[corners[3]] - a : c;
    const glm::dvec3 vector_area = 0.5 * (element.size() == 4 ? glm::cross(c, d - b) : glm::cross(b, c));
    element.area = glm::length(vector_area);
    if (!(element.area > 0)) return element;
    element.normal = vector_area / element.area;
    const double abc = glm::dot(glm::cross(b, c), element.normal), acd = glm::dot(glm::cross(c, d), element.normal);
    element.center = a + (abc * (b + c) + acd * (c + d)) / (3 * (abc + acd));
    return element;
}

Element turned(Element element) {
    std::reverse(element.corners.begin(), element.corners.begin() + static_cast<std::ptrdiff_t>(element.size()));
    element.normal = -element.normal;
    return element;
}

class Assembler {
  public:
    Assembler(const BaseMesh& base, const BaseEdges& edges, Cutting&& cutting, double patch)
        : base_(base), cutting_(std::move(cutting)), groups_(smooth_groups(base, edges)),
          patch_of_unit_(gather_units(base, cutting_, groups_, patch)), group_numbers_(2 * base.faces.size(), kNone) {}
    PatchMesh run();
    std::vector<std::uint32_t> face_of_element;

  private:
    void sort_pieces();
    std::uint32_t group_number(std::uint32_t face, bool back);
    void add_patches(bool back);
    void add(const Piece& piece, bool back);
    void finish(Patch& patch) const;

    const BaseMesh& base_;
    Cutting cutting_;
    const std::vector<std::uint32_t> groups_, patch_of_unit_;
    std::vector<std::uint32_t> group_numbers_; // fronts, backs; in order of first use
    std::uint32_t group_count_ = 0;
    std::vector<std::uint32_t> starts_; // of pieces, by unit that gives a patch its number
    std::vector<std::uint32_t> order_;  // pieces
    std::vector<std::uint32_t> fronts_; // a piece's element
    PatchMesh mesh_;
};

void Assembler::sort_pieces() {
    const auto place = [&](const Piece& piece) { return patch_of_unit_[piece.unit]; };
    starts_.assign(cutting_.units.size() + 1, 0);
    for (const Piece& piece : cutting_.pieces) ++starts_[place(piece) + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    order_.resize(cutting_.pieces.size());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < order_.size(); ++i) order_[next[place(cutting_.pieces[i])]++] = i;
}

std::uint32_t Assembler::group_number(std::uint32_t face, bool back) {
    std::uint32_t& number = group_numbers_[2 * std::size_t(groups_[face]) + (back ? 1 : 0)];
    if (number == kNone) number = group_count_++;
    return number;
}

void Assembler::add(const Piece& piece, bool back) {
    Element element = element_of(mesh_.points, piece.corners);
    if (!(element.area > 0)) return;
    const auto number = static_cast<std::uint32_t>(mesh_.elements.size());
    const auto index = static_cast<std::size_t>(&piece - cutting_.pieces.data());
    if (back) {
        element = turned(element);
        element.behind = fronts_[index];
        mesh_.elements[element.behind].behind = number;
    } else {
        fronts_[index] = number;
    }
    element.patch = static_cast<std::uint32_t>(mesh_.patches.size());
    element.surface = base_.faces[piece.face].surface;
    element.group = group_number(piece.face, back);
    mesh_.elements.push_back(element);
    face_of_element.push_back(piece.face);
}

void Assembler::finish(Patch& patch) const {
    const std::span elements(mesh_.elements.data() + patch.first, patch.count);
    for (const Element& e : elements) patch.area += e.area, patch.center += e.area * e.center, patch.normal += e.area * e.normal;
    patch.center /= patch.area;
    patch.normal = glm::normalize(patch.normal);
    for (const Element& e : elements)
        for (std::size_t i = 0; i < e.size(); ++i)
            patch.radius = std::max(patch.radius, glm::distance(mesh_.points[e.corners[i]], patch.center));
}

// Of all fronts, or of all backs that there are.
void Assembler::add_patches(bool back) {
    for (std::size_t u = 0; u + 1 < starts_.size(); ++u) {
        Patch patch;
        patch.first = static_cast<std::uint32_t>(mesh_.elements.size());
        for (std::uint32_t i = starts_[u]; i < starts_[u + 1]; ++i) {
            const Piece& piece = cutting_.pieces[order_[i]];
            if (!back || base_.faces[piece.face].two_sided) add(piece, back);
        }
        patch.count = static_cast<std::uint32_t>(mesh_.elements.size()) - patch.first;
        if (patch.count == 0) continue;
        finish(patch);
        mesh_.patches.push_back(patch);
    }
}

PatchMesh Assembler::run() {
    mesh_.points = std::move(cutting_.points);
    mesh_.elements.reserve(cutting_.sides);
    fronts_.resize(cutting_.pieces.size(), kNone);
    sort_pieces();
    add_patches(false);
    add_patches(true);
    return std::move(mesh_);
}

double patch_for(const PatchRequest& request, double element) {
    return std::max(element, request.patch > 0 ? request.patch : kElementsAcross * element);
}

// What is cut for one try of a size, in metres.
struct Try {
    double element = 0, patch = 0;
    BaseMesh base;
    BaseEdges edges;
    Cutting cutting;
};

Try cut_at(const Scene& scene, const Frame& frame, double element, double patch) {
    Try t;
    t.element = element;
    t.patch = patch;
    t.base = base_faces(scene, frame, frame.scale * element);
    t.edges = edges_of(t.base);
    pair_triangles(t.base, t.edges, smooth_groups(t.base, t.edges));
    t.edges = edges_of(t.base);
    t.cutting = cut(t.base, t.edges, {frame.scale * t.element, frame.scale * t.patch});
    return t;
}

// What all sides would come to in elements of a square metre: of a surface that is cut by bisection a triangle has about a quarter of the
// square of the longest edge allowed.
double elements_of(const BaseMesh& base) {
    double area = 0;
    for (const BaseFace& face : base.faces) {
        glm::dvec3 sum(0);
        const auto loop = base.loop(face);
        const glm::dvec3 origin = base.points[loop[0].point];
        for (std::size_t i = 2; i < loop.size(); ++i)
            sum += glm::cross(base.points[loop[i - 1].point] - origin, base.points[loop[i].point] - origin);
        area += (face.count == 4 ? 1 : 4) * (face.two_sided ? 1 : 0.5) * glm::length(sum);
    }
    return area / (base.frame.scale * base.frame.scale);
}

// The number of elements goes with the square of their size, about, as far as no face is an element already: a few tries come near what was
// asked for, and the nearest is taken.
Try cut_into(const Scene& scene, const Frame& frame, const PatchRequest& request) {
    constexpr int kTries = 5;
    constexpr double kNearEnough = 1.1;
    const double wanted = double(std::max<std::size_t>(request.elements, 1)), widest = 2 * frame.radius / frame.scale;
    double element = std::sqrt(elements_of(base_faces(scene, frame, frame.radius / 4)) / wanted), nearest = 0;
    if (!(element > 0)) element = widest;
    std::optional<Try> best;
    for (int i = 1; i <= kTries; ++i) try {
            Try t = cut_at(scene, frame, element, patch_for(request, element));
            const double ratio = double(t.cutting.sides) / wanted, off = std::max(ratio, 1 / ratio);
            const bool last = off < kNearEnough || t.cutting.sides == 0 || (ratio > 1 && element >= widest);
            if (!best || off < nearest) best = std::move(t), nearest = off;
            if (last) break;
            element = std::min(element * std::sqrt(ratio), widest);
        } catch (const std::length_error&) {
            if (best) break;
            if (i == kTries || element >= widest) throw;
            element = std::min(4 * element, widest);
        }
    // Where the faces are smaller than the elements could be, patches are made for what there is.
    const double typical = 2 * std::sqrt(elements_of(best->base) / double(std::max<std::size_t>(best->cutting.sides, 1)));
    if (typical > 0 && typical < best->element) {
        best = cut_at(scene, frame, best->element, patch_for(request, typical));
        best->element = typical;
    }
    return std::move(*best);
}

} // namespace

PatchMesh make_patches(const Scene& scene, const PatchRequest& request) {
    const Frame frame = frame_of(bounds_of(scene));
    Try t =
        request.element > 0 ? cut_at(scene, frame, request.element, patch_for(request, request.element)) : cut_into(scene, frame, request);
    Assembler assembler(t.base, t.edges, std::move(t.cutting), frame.scale * t.patch);
    PatchMesh mesh = assembler.run();
    mark_covered(scene, t.base, t.edges, assembler.face_of_element, mesh);
    mesh.frame = frame;
    mesh.surfaces = std::move(t.base.surfaces);
    mesh.element_size = t.element, mesh.patch_size = t.patch;
    mesh.dropped = t.base.dropped;
    return mesh;
}

void make_elements_patches(PatchMesh& mesh) {
    mesh.patches.clear();
    for (Element& element : mesh.elements) {
        const auto number = static_cast<std::uint32_t>(mesh.patches.size());
        Patch patch{number, 1, element.center, element.normal, element.area, 0};
        for (std::size_t i = 0; i < element.size(); ++i)
            patch.radius = std::max(patch.radius, glm::distance(mesh.points[element.corners[i]], element.center));
        element.patch = number;
        mesh.patches.push_back(patch);
    }
}

} // namespace lightbench
