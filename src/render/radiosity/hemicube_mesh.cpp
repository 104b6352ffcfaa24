// Where hemi-cubes stand and how they are turned, and the triangles that they see.
#include "render/radiosity/hemicube_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

namespace lightbench {
namespace {

using namespace gpu_layout;

glm::vec3 corner_of(const PatchMesh& mesh, const Element& e, std::size_t k) {
    return glm::vec3(mesh.points[e.corners[std::min(k, e.size() - 1)]]);
}

struct Triangle {
    glm::dvec3 v0, v1, v2; // as float has them
};

// The fan from its first corner.
Triangle triangle_of(const PatchMesh& mesh, const Element& e, std::size_t k) {
    return {corner_of(mesh, e, 0), corner_of(mesh, e, k + 1), corner_of(mesh, e, k + 2)};
}

// How far along `normal` from `p` the triangle is; none if the line passes it by. Cramer's rule (Moeller and Trumbore 1997, "Fast, minimum
// storage ray-triangle intersection"). Centres lie on edges where elements meet: a line 1e-6 outside still meets the triangle.
std::optional<double> height_of(const Triangle& t, const glm::dvec3& p, const glm::dvec3& normal) {
    const glm::dvec3 e1 = t.v1 - t.v0, e2 = t.v2 - t.v0, from = p - t.v0, q = glm::cross(from, e1), across = glm::cross(normal, e2);
    const double determinant = glm::dot(e1, across);
    if (determinant == 0) return std::nullopt;
    const double b1 = glm::dot(from, across) / determinant, b2 = glm::dot(normal, q) / determinant;
    if (b1 < -1e-6 || b2 < -1e-6 || b1 + b2 > 1 + 1e-6) return std::nullopt;
    return glm::dot(e2, q) / determinant;
}

// Where rays from a surface start: on the outermost of its own triangles that the normal meets, for a curved surface has its centre beneath
// them, and then beyond what a next ray may be wrong by (shaders/lib/ray_triangle.glsl: gamma(4) of the coordinates, gamma(2) and gamma(4) of
// the reach; the same again for the rounding of the point itself).
glm::vec3 above_surface(const PatchMesh& mesh, std::span<const Element> own, const glm::dvec3& center, const glm::dvec3& normal) {
    double height = -INFINITY, reach = 0;
    for (const Element& e : own)
        for (std::size_t k = 0; k + 2 < e.size(); ++k) {
            const Triangle t = triangle_of(mesh, e, k);
            const auto met = height_of(t, center, normal);
            if (!met) continue;
            height = std::max(height, *met);
            for (const glm::dvec3& v : {t.v0, t.v1, t.v2}) reach = std::max(reach, glm::length(v - center));
        }
    if (height == -INFINITY) height = 0;
    const glm::dvec3 error = 0x1p-24 * (8.0 * (glm::abs(center) + reach) + 6.0 * reach);
    const glm::dvec3 q = center + normal * (height + glm::dot(glm::abs(normal), error));
    glm::vec3 out(q);
    for (int i = 0; i < 3; ++i)
        if (normal[i] != 0) out[i] = std::nextafter(out[i], normal[i] > 0 ? INFINITY : -INFINITY);
    return out;
}

// Turned about the normal by the patch's own angle, so that the pixels of neighbours do not line up with the same edges (HC-6). Knuth 1973,
// "The art of computer programming", vol. 3, sec. 6.4: multiples of the golden ratio spread evenly, however many of them there are.
glm::dvec3 tangent_of(const glm::dvec3& normal, std::uint32_t patch) {
    const glm::dvec3 m = glm::abs(normal);
    const glm::dvec3 axis = m.x <= m.y && m.x <= m.z ? glm::dvec3(1, 0, 0) : m.y <= m.z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, normal)), v = glm::cross(normal, u);
    const double angle = patch * 2654435769u * 0x1p-32 * 0.5 * std::numbers::pi; // a quarter turn brings the hemi-cube to itself
    return std::cos(angle) * u + std::sin(angle) * v;
}

bool stands_for_surface(const PatchMesh& mesh, std::uint32_t i) {
    const Element& e = mesh.elements[i];
    if (e.behind == kNoElement) return !e.covered;
    const Element& other = mesh.elements[e.behind];
    return i < e.behind && !(e.covered && other.covered);
}

void add_triangles(HemicubeMesh& out, const PatchMesh& mesh, std::uint32_t i) {
    const Element& e = mesh.elements[i];
    for (std::size_t k = 0; k + 2 < e.size(); ++k) {
        const auto number = static_cast<std::uint32_t>(out.primitives.triangles.size());
        out.primitives.triangles.push_back(
            {corner_of(mesh, e, 0), number, corner_of(mesh, e, k + 1), i, corner_of(mesh, e, k + 2), e.behind});
    }
}

// Vertices are shared; each one provokes the triangles of one element at most.
class FaceBuilder {
  public:
    FaceBuilder(HemicubeMesh& out, const PatchMesh& mesh) : out_(out), mesh_(mesh), provokes_(mesh.points.size(), kNoElement) {
        for (const glm::dvec3& p : mesh.points) out.vertices.push_back({glm::vec3(p), {kNoElement, kNoElement}});
    }

    void add(std::uint32_t i) {
        const Element& e = mesh_.elements[i];
        std::size_t first = 0;
        while (first < e.size() && provokes_[e.corners[first]] != kNoElement) ++first;
        const bool all_taken = first == e.size();
        if (all_taken) first = 0;
        std::uint32_t provoking = e.corners[first];
        if (all_taken) {
            out_.vertices.push_back(out_.vertices[provoking]);
            provoking = static_cast<std::uint32_t>(out_.vertices.size() - 1);
        } else {
            provokes_[provoking] = i;
        }
        out_.vertices[provoking].sides = {i, e.behind};
        for (std::size_t k = 1; k + 1 < e.size(); ++k)
            out_.indices.insert(out_.indices.end(), {provoking, e.corners[(first + k) % e.size()], e.corners[(first + k + 1) % e.size()]});
    }

  private:
    HemicubeMesh& out_;
    const PatchMesh& mesh_;
    std::vector<std::uint32_t> provokes_; // by point: the element
};

Receiver receiver_of(const PatchMesh& mesh, const Element& e) {
    Receiver r{};
    r.center = above_surface(mesh, std::span(&e, 1), e.center, e.normal);
    r.area = static_cast<float>(e.area), r.normal = glm::vec3(e.normal), r.patch_number = e.patch, r.covered = e.covered;
    return r;
}

// What of a patch sends light: what is not covered. If some is, the hemi-cube stands on the element next to the middle of the rest.
struct Open {
    glm::dvec3 center;
    double area;
};

Open open_part(const PatchMesh& mesh, const Patch& p) {
    const auto elements = std::span(mesh.elements).subspan(p.first, p.count);
    glm::dvec3 sum(0);
    double area = 0;
    for (const Element& e : elements)
        if (!e.covered) sum += e.area * e.center, area += e.area;
    if (area == 0 || std::ranges::none_of(elements, &Element::covered)) return {p.center, p.area};
    const auto far = [&](const Element& e) { return e.covered ? 1e300 : glm::length(e.center - sum / area); };
    return {std::ranges::min_element(elements, {}, far)->center, area};
}

Shooter shooter_of(const PatchMesh& mesh, std::uint32_t i) {
    const Patch& p = mesh.patches[i];
    const Open open = open_part(mesh, p);
    Shooter s{};
    s.center = above_surface(mesh, std::span(mesh.elements).subspan(p.first, p.count), open.center, p.normal);
    s.area = static_cast<float>(open.area), s.normal = glm::vec3(p.normal), s.radius = static_cast<float>(p.radius);
    s.tangent = glm::vec3(tangent_of(p.normal, i)), s.first = p.first, s.count = p.count;
    return s;
}

} // namespace

HemicubeMesh hemicube_mesh(const PatchMesh& mesh) {
    HemicubeMesh out;
    out.primitives.frame = mesh.frame;
    FaceBuilder faces(out, mesh);
    for (std::uint32_t i = 0; i < mesh.elements.size(); ++i) {
        const Element& e = mesh.elements[i];
        out.receivers.push_back(receiver_of(mesh, e));
        for (std::size_t k = 0; k < 4; ++k) out.corners.emplace_back(glm::floatBitsToUint(corner_of(mesh, e, k)), 0);
        if (!stands_for_surface(mesh, i)) continue;
        add_triangles(out, mesh, i);
        faces.add(i);
    }
    for (std::uint32_t i = 0; i < mesh.patches.size(); ++i) out.shooters.push_back(shooter_of(mesh, i));
    return out;
}

} // namespace lightbench
