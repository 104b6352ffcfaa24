// Gradients of uv, of faces by Green's theorem and of vertices by angle-weighted means. In: faces with texture points. Out: Details.
#include "scene/tessellate_detail.h"

#include "scene/normals.h"

#include <cmath>

namespace lightbench {
namespace {

struct FaceDetail {
    Detail detail;
    int handedness = 0; // +1: uv runs counter-clockwise as the face does; -1: mirrored; 0: no area
};

// Twice the signed area of the loop in uv, or 0 if it is none beyond rounding: as for face_normal(), differences of float32 are exact, a
// product carries at most 4 u of its size.
double twice_uv_area(const Faces& faces, std::span<const std::uint32_t> textures) {
    const glm::dvec2 origin = faces.texture_points[textures[0]].uv;
    glm::dvec2 a = faces.texture_points[textures[1]].uv - origin;
    double sum = 0, products = 0;
    for (std::size_t i = 2; i < textures.size(); ++i) {
        const glm::dvec2 b = faces.texture_points[textures[i]].uv - origin;
        sum += a.x * b.y - a.y * b.x;
        products += std::sqrt(glm::dot(a, a) * glm::dot(b, b));
        a = b;
    }
    return std::abs(sum) > 0x1p-51 * products ? sum : 0;
}

// Green's theorem: the mean gradient over a polygon is the integral of u along its rim times the outward normal of the rim, over the area.
// Of a triangle that is the gradient of the linear u; any other face has no single one.
FaceDetail detail_of_face(const Faces& faces, std::size_t face, const glm::dvec3& normal) {
    const auto loop = faces.loop(face);
    const auto textures = faces.textures(face);
    FaceDetail made;
    glm::dvec2 sum(0);
    for (std::uint32_t t : textures) sum += faces.texture_points[t].uv;
    made.detail.uv = sum / double(loop.size());
    const double uv_area = twice_uv_area(faces, textures);
    if (uv_area == 0) return made;
    made.handedness = uv_area > 0 ? 1 : -1;
    const glm::dvec3 origin = faces.points[loop[0].point];
    double twice_area = 0;
    for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
        const glm::dvec3 a = faces.points[loop[i].point] - origin, b = faces.points[loop[(i + 1) % n].point] - origin;
        const glm::dvec3 outward = glm::cross(b - a, normal);
        // About the middle, so that a large uv loses nothing.
        const glm::dvec2 uv = faces.texture_points[textures[i]].uv + faces.texture_points[textures[(i + 1) % n]].uv - 2.0 * made.detail.uv;
        made.detail.u_gradient += uv.x * outward;
        made.detail.v_gradient += uv.y * outward;
        twice_area += glm::dot(glm::cross(a, b), normal);
    }
    made.detail.u_gradient /= twice_area;
    made.detail.v_gradient /= twice_area;
    return made;
}

glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& unit_normal) {
    return v - glm::dot(v, unit_normal) * unit_normal;
}

class VertexDetails {
  public:
    explicit VertexDetails(const Faces& faces, Details& made) : faces_(faces), made_(made), first_(faces.points.size(), kNone) {}
    void add(std::size_t face, const FaceDetail& of_face, const glm::dvec3& normal);
    void finish();

  private:
    std::uint32_t group(const Corner& corner, std::uint32_t texture, int handedness);
    void follow_tangent(Detail& detail, const TexturePoint& texture, const glm::dvec3& normal) const;

    struct Key {
        std::uint32_t normal, texture;
        int handedness;
        bool operator==(const Key&) const = default;
    };
    const Faces& faces_;
    Details& made_;
    std::vector<std::uint32_t> first_, next_; // groups of a point: a chain
    std::vector<Key> keys_;                   // of groups
    std::vector<double> angles_;              // of groups: sum
};

std::uint32_t VertexDetails::group(const Corner& corner, std::uint32_t texture, int handedness) {
    const Key key{corner.normal, texture, handedness};
    std::uint32_t* link = &first_[corner.point];
    for (; *link != kNone; link = &next_[*link])
        if (keys_[*link] == key) return *link;
    const auto made = static_cast<std::uint32_t>(keys_.size());
    *link = made;
    next_.push_back(kNone), keys_.push_back(key), angles_.push_back(0);
    made_.of_vertices.push_back({faces_.texture_points[texture].uv, {}, {}});
    return made;
}

void VertexDetails::add(std::size_t face, const FaceDetail& of_face, const glm::dvec3& normal) {
    const auto loop = faces_.loop(face);
    const auto textures = faces_.textures(face);
    for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
        const glm::dvec3 here = faces_.points[loop[i].point];
        const double angle =
            corner_angle(faces_.points[loop[(i + 1) % n].point] - here, faces_.points[loop[(i + n - 1) % n].point] - here, normal);
        const std::uint32_t g = group(loop[i], textures[i], of_face.handedness);
        made_.of_vertices[g].u_gradient += angle * of_face.detail.u_gradient;
        made_.of_vertices[g].v_gradient += angle * of_face.detail.v_gradient;
        angles_[g] += angle;
        made_.of_corners.push_back(g);
    }
}

// glTF 2.0, sec. 3.7.2.1: the way of v is cross(normal, tangent) times w. Only the lengths are those of the layout.
void VertexDetails::follow_tangent(Detail& detail, const TexturePoint& texture, const glm::dvec3& normal) const {
    const glm::dvec3 tangent = across(glm::dvec3(texture.tangent), normal);
    const double length = glm::length(tangent);
    if (!(length > 0) || texture.tangent.w == 0) return;
    const glm::dvec3 t = tangent / length;
    detail.u_gradient = glm::length(detail.u_gradient) * t;
    detail.v_gradient = (texture.tangent.w < 0 ? -1.0 : 1.0) * glm::length(detail.v_gradient) * glm::cross(normal, t);
}

void VertexDetails::finish() {
    for (std::size_t g = 0; g < keys_.size(); ++g) {
        Detail& detail = made_.of_vertices[g];
        const glm::dvec3& normal = faces_.normals[keys_[g].normal];
        const double weight = angles_[g] > 0 ? 1 / angles_[g] : 0;
        detail.u_gradient = across(weight * detail.u_gradient, normal);
        detail.v_gradient = across(weight * detail.v_gradient, normal);
        follow_tangent(detail, faces_.texture_points[keys_[g].texture], normal);
    }
}

} // namespace

Details details_of(const Faces& faces, const std::vector<glm::dvec3>& of_faces, bool vertices) {
    Details made;
    made.of_faces.reserve(faces.count());
    if (vertices) made.of_corners.reserve(faces.corners.size());
    VertexDetails of_vertices(faces, made);
    for (std::size_t f = 0; f < faces.count(); ++f) {
        const FaceDetail of_face = detail_of_face(faces, f, of_faces[f]);
        if (vertices) of_vertices.add(f, of_face, of_faces[f]);
        made.of_faces.push_back(of_face.detail);
    }
    if (vertices) of_vertices.finish();
    return made;
}

} // namespace lightbench
