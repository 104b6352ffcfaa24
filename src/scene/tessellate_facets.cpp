// Triangulates faces and makes their vertices unique. In: Faces and their normals. Out: Facets.
#include "scene/tessellate_facets.h"

#include "scene/triangulate.h"

namespace lightbench {
namespace {

class FacetMaker {
  public:
    FacetMaker(const Faces& faces, const std::vector<glm::dvec3>& of_faces, bool normals, Details* details)
        : faces_(faces), of_faces_(of_faces), normals_(normals), details_(details), first_(faces.points.size(), kNone) {}
    Facets run();

  private:
    std::uint32_t detail_of(std::size_t corner) const { return normals_ && details_ ? details_->of_corners[corner] : kNone; }
    std::uint32_t vertex(const Corner& corner, std::uint32_t material, std::uint32_t detail);
    void add_face(std::uint32_t face);
    void triangulate_face(std::uint32_t face);

    const Faces& faces_;
    const std::vector<glm::dvec3>& of_faces_;
    const bool normals_;
    Details* const details_;
    std::vector<std::uint32_t> first_, next_; // vertices of a point: a chain
    std::vector<std::uint32_t> vertex_normals_, vertex_details_, loop_;
    std::vector<glm::dvec3> loop_points_;
    std::vector<CornerTriple> triples_;
    Facets made_;
};

std::uint32_t FacetMaker::vertex(const Corner& corner, std::uint32_t material, std::uint32_t detail) {
    const std::uint32_t normal = normals_ ? corner.normal : kNone;
    if (!normals_) material = kNone;
    std::uint32_t* link = &first_[corner.point];
    for (; *link != kNone; link = &next_[*link])
        if (vertex_normals_[*link] == normal && (material == kNone || made_.vertex_materials[*link] == material) &&
            (detail == kNone || vertex_details_[*link] == detail))
            return *link;
    const auto made = static_cast<std::uint32_t>(made_.positions.size());
    *link = made;
    next_.push_back(kNone);
    vertex_normals_.push_back(normal);
    made_.positions.push_back(faces_.points[corner.point]);
    if (normals_) made_.normals.push_back(faces_.normals[normal]);
    if (material != kNone) made_.vertex_materials.push_back(material);
    if (detail != kNone) {
        vertex_details_.push_back(detail);
        made_.details.push_back(details_->of_vertices[detail]);
    }
    return made;
}

// The triangles of loop_ as triples of its corners.
void FacetMaker::triangulate_face(std::uint32_t face) {
    triples_.clear();
    if (loop_.size() == 3)
        triples_.push_back({0, 1, 2});
    else {
        loop_points_.clear();
        for (const Corner& c : faces_.loop(face)) loop_points_.push_back(faces_.points[c.point]);
        triangulate(flatten(loop_points_, of_faces_[face]), triples_);
    }
}

void FacetMaker::add_face(std::uint32_t face) {
    const std::uint32_t material = faces_.materials.empty() ? kNone : faces_.materials[face];
    const auto loop = faces_.loop(face);
    glm::dvec3 sum(0);
    loop_.clear();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        loop_.push_back(vertex(loop[i], material, detail_of(faces_.starts[face] + i)));
        sum += faces_.points[loop[i].point];
    }
    if (!faces_.hubs.empty() && faces_.hubs[face].point != kNone) {
        const std::uint32_t hub = vertex(faces_.hubs[face], material, kNone); // primitives have no detail
        for (std::size_t i = 0; i < loop_.size(); ++i) made_.triangles.push_back({hub, loop_[i], loop_[(i + 1) % loop_.size()]});
    } else {
        triangulate_face(face);
        for (const auto& t : triples_) made_.triangles.push_back({loop_[t[0]], loop_[t[1]], loop_[t[2]]});
    }
    made_.triangle_faces.resize(made_.triangles.size(), face);
    made_.face_centers.push_back(sum / double(loop.size()));
}

Facets FacetMaker::run() {
    made_.triangles.reserve(faces_.corners.size() - 2 * faces_.count());
    for (std::uint32_t face = 0; face < faces_.count(); ++face) add_face(face);
    made_.anchor = faces_.anchor;
    made_.face_normals = of_faces_;
    made_.face_materials = faces_.materials;
    if (details_) made_.face_details = std::move(details_->of_faces);
    return std::move(made_);
}

} // namespace

Facets facets_of(const Faces& faces, const std::vector<glm::dvec3>& of_faces, bool normals, Details* details) {
    return FacetMaker(faces, of_faces, normals, details).run();
}

} // namespace lightbench
