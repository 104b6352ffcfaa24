// What the header of the same name says.
#include "radiosity/reconstruct.h"

#include <algorithm>

namespace lightbench {
namespace {

// A corner of an element.
struct Spot {
    std::uint32_t element, corner;
};

// Points as their groups see them: a vertex is a point in a group.
class Reconstructor {
  public:
    Reconstructor(const PatchMesh& mesh, std::span<const glm::vec3> values);
    std::vector<std::array<glm::vec3, 4>> run();

  private:
    struct Fit {
        glm::dvec3 mean{0}, center{0}; // of values, of places; weighted by area
    };
    void number_vertices();
    std::span<const Spot> around(std::uint32_t v) const { return {spots_.data() + starts_[v], covered_[v] - starts_[v]}; }
    std::span<const Spot> covered_around(std::uint32_t v) const { return {spots_.data() + covered_[v], starts_[v + 1] - covered_[v]}; }
    std::uint32_t vertex(std::uint32_t element, std::size_t corner) const { return vertices_[element][corner]; }
    std::uint32_t neighbour(const Spot& s, std::size_t steps) const {
        const std::size_t n = mesh_.elements[s.element].size();
        return vertex(s.element, (s.corner + steps) % n);
    }
    bool is_inside(std::uint32_t v);
    Fit mean_of(std::span<const std::uint32_t> elements) const;
    std::uint32_t inner_point(std::uint32_t v) const;
    void gather_neighbourhood(std::uint32_t v);
    glm::dvec3 on_plane(std::uint32_t v, const Fit& fit);
    glm::dvec3 on_border(std::uint32_t v);
    glm::dvec3 beyond(std::uint32_t v) const;
    void find_values();

    const PatchMesh& mesh_;
    const std::span<const glm::vec3> values_;
    std::vector<std::array<std::uint32_t, 4>> vertices_; // of each element's corners
    std::vector<std::uint32_t> starts_, covered_;        // of spots_, by vertex; from covered_ on the elements are covered
    std::vector<Spot> spots_;
    std::vector<bool> inside_;
    std::vector<glm::dvec3> of_vertices_;
    std::vector<std::uint32_t> elements_, leaving_, arriving_; // of the vertex in work
};

Reconstructor::Reconstructor(const PatchMesh& mesh, std::span<const glm::vec3> values)
    : mesh_(mesh), values_(values), vertices_(mesh.elements.size()) {
    number_vertices();
}

// Sorted by point and group; within a vertex by element, those that are covered last.
void Reconstructor::number_vertices() {
    struct Key {
        std::uint64_t point_group;
        bool covered;
        Spot spot;
        bool operator<(const Key& o) const { return point_group != o.point_group ? point_group < o.point_group : covered < o.covered; }
    };
    std::vector<Key> keys;
    for (std::uint32_t e = 0; e < mesh_.elements.size(); ++e) {
        const Element& element = mesh_.elements[e];
        for (std::uint32_t i = 0; i < element.size(); ++i)
            keys.push_back({(std::uint64_t{element.corners[i]} << 32) | element.group, element.covered, {e, i}});
    }
    std::stable_sort(keys.begin(), keys.end());
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
        if (i == 0 || keys[i].point_group != keys[i - 1].point_group) starts_.push_back(i), covered_.push_back(i);
        if (!keys[i].covered) covered_.back() = i + 1;
        vertices_[keys[i].spot.element][keys[i].spot.corner] = static_cast<std::uint32_t>(starts_.size() - 1);
        spots_.push_back(keys[i].spot);
    }
    starts_.push_back(static_cast<std::uint32_t>(keys.size()));
}

// Every edge that leaves the vertex along one element comes back along another.
bool Reconstructor::is_inside(std::uint32_t v) {
    leaving_.clear(), arriving_.clear();
    for (const Spot& s : around(v)) {
        leaving_.push_back(neighbour(s, 1));
        arriving_.push_back(neighbour(s, mesh_.elements[s.element].size() - 1));
    }
    std::sort(leaving_.begin(), leaving_.end());
    std::sort(arriving_.begin(), arriving_.end());
    return leaving_ == arriving_;
}

Reconstructor::Fit Reconstructor::mean_of(std::span<const std::uint32_t> elements) const {
    Fit fit;
    double weight = 0;
    for (std::uint32_t e : elements) {
        const Element& element = mesh_.elements[e];
        weight += element.area;
        fit.mean += element.area * glm::dvec3(values_[e]);
        fit.center += element.area * element.center;
    }
    fit.mean /= weight, fit.center /= weight;
    return fit;
}

// E of a vertex that one quadrilateral has, or two that share an edge; kNoCorner: there is none, or it is not inside.
std::uint32_t Reconstructor::inner_point(std::uint32_t v) const {
    const auto spots = around(v);
    if (std::any_of(spots.begin(), spots.end(), [&](const Spot& s) { return mesh_.elements[s.element].size() != 4; })) return kNoCorner;
    std::uint32_t found = kNoCorner;
    if (spots.size() == 1) found = neighbour(spots[0], 2);
    if (spots.size() == 2) {
        if (neighbour(spots[0], 1) == neighbour(spots[1], 3)) found = neighbour(spots[0], 1);
        if (neighbour(spots[1], 1) == neighbour(spots[0], 3)) found = neighbour(spots[1], 1);
    }
    return found != kNoCorner && inside_[found] ? found : kNoCorner;
}

// All elements of the group that share a point with those around the vertex, in order.
void Reconstructor::gather_neighbourhood(std::uint32_t v) {
    elements_.clear();
    for (const Spot& s : around(v))
        for (std::size_t i = 0; i < mesh_.elements[s.element].size(); ++i)
            for (const Spot& other : around(vertex(s.element, i))) elements_.push_back(other.element);
    std::sort(elements_.begin(), elements_.end());
    elements_.erase(std::unique(elements_.begin(), elements_.end()), elements_.end());
}

// Least squares in the tangent plane, about the mean. Centres that lie nearly on a line say nothing of the slope across it: it would be
// what is not linear, times their length over their width; that is taken up to 8, the square of which is the ratio of the moments.
glm::dvec3 Reconstructor::on_plane(std::uint32_t v, const Fit& near) {
    gather_neighbourhood(v);
    const Fit fit = mean_of(elements_);
    const Element& first = mesh_.elements[around(v)[0].element];
    const glm::dvec3 x = glm::normalize(mesh_.points[first.corners[1]] - mesh_.points[first.corners[0]]), y = glm::cross(first.normal, x);
    double xx = 0, xy = 0, yy = 0;
    glm::dvec3 bx(0), by(0);
    for (std::uint32_t e : elements_) {
        const Element& element = mesh_.elements[e];
        const glm::dvec3 d = element.center - fit.center, value = element.area * (glm::dvec3(values_[e]) - fit.mean);
        const double u = glm::dot(d, x), w = glm::dot(d, y);
        xx += element.area * u * u, xy += element.area * u * w, yy += element.area * w * w;
        bx += u * value, by += w * value;
    }
    const double determinant = xx * yy - xy * xy, trace = xx + yy;
    if (!(determinant > trace * trace / 64)) return near.mean;
    const glm::dvec3 at = mesh_.points[first.corners[around(v)[0].corner]] - near.center;
    const glm::dvec3 slope_x = (yy * bx - xy * by) / determinant, slope_y = (xx * by - xy * bx) / determinant;
    return near.mean + glm::dot(at, x) * slope_x + glm::dot(at, y) * slope_y;
}

glm::dvec3 Reconstructor::on_border(std::uint32_t v) {
    elements_.clear();
    bool quadrilaterals = true;
    for (const Spot& s : around(v)) {
        elements_.push_back(s.element);
        quadrilaterals = quadrilaterals && mesh_.elements[s.element].size() == 4;
    }
    const Fit near = mean_of(elements_);
    if (const std::uint32_t inner = inner_point(v); inner != kNoCorner) return 2.0 * near.mean - of_vertices_[inner];
    return quadrilaterals && elements_.size() < 3 ? near.mean : on_plane(v, near);
}

// Of a vertex among covered elements alone: what their other corners have, so that the part of an element that is seen beside its cover
// goes on as it begins.
glm::dvec3 Reconstructor::beyond(std::uint32_t v) const {
    glm::dvec3 sum(0);
    double count = 0;
    for (const Spot& s : covered_around(v))
        for (std::size_t i = 0; i < mesh_.elements[s.element].size(); ++i)
            if (const std::uint32_t other = vertex(s.element, i); !around(other).empty()) sum += of_vertices_[other], ++count;
    return count > 0 ? sum / count : sum;
}

void Reconstructor::find_values() {
    const auto count = static_cast<std::uint32_t>(covered_.size());
    of_vertices_.resize(count), inside_.resize(count);
    for (std::uint32_t v = 0; v < count; ++v) {
        inside_[v] = !around(v).empty() && is_inside(v);
        if (!inside_[v]) continue;
        elements_.clear();
        for (const Spot& s : around(v)) elements_.push_back(s.element);
        of_vertices_[v] = mean_of(elements_).mean;
    }
    for (std::uint32_t v = 0; v < count; ++v)
        if (!inside_[v] && !around(v).empty()) of_vertices_[v] = glm::max(on_border(v), glm::dvec3(0));
    for (std::uint32_t v = 0; v < count; ++v)
        if (around(v).empty()) of_vertices_[v] = beyond(v);
}

std::vector<std::array<glm::vec3, 4>> Reconstructor::run() {
    find_values();
    std::vector<std::array<glm::vec3, 4>> corners(mesh_.elements.size());
    for (std::uint32_t e = 0; e < corners.size(); ++e)
        for (std::size_t i = 0; i < mesh_.elements[e].size(); ++i)
            corners[e][i] = glm::max(glm::vec3(of_vertices_[vertex(e, i)]), glm::vec3(0));
    return corners;
}

} // namespace

std::vector<std::array<glm::vec3, 4>> corner_values(const PatchMesh& mesh, std::span<const glm::vec3> of_elements) {
    return Reconstructor(mesh, of_elements).run();
}

} // namespace lightbench
