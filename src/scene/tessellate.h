// From the analytic scene to what the rasteriser draws: vertex and polygon streams, triangles in clusters. Pure, no Vulkan.
#pragma once

#include "scene/scene.h"
#include "shared/layouts.h"

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace lightbench {

// Geometry is handed on in the *frame*: p_frame = scale * (p_world - origin), scale a power of two that brings the scene's radius into [1, 2).
// So a scene 1e5 metres from the origin loses nothing (SC-2), and one of 1e-6 metres renders the same bits as one of 1e6 (SC-1).
struct Frame {
    glm::dvec3 origin{0}; // metres, centre of the scene's bounding box
    double scale = 1;     // frame units per metre, 2^k
    double radius = 1;    // frame units, of the sphere about the origin that holds every object
    glm::dvec3 from_world(const glm::dvec3& p) const { return scale * (p - origin); }
};

struct Bounds {
    glm::dvec3 min{1e300}, max{-1e300};
    bool empty() const { return min.x > max.x; }
    void add(const glm::dvec3& p) { min = glm::min(min, p), max = glm::max(max, p); }
};

// Tight for meshes and polygons, conservative for transformed curved shapes. World space.
Bounds bounds_of(const Scene& scene);
Bounds bounds_of(const Scene& scene, const Object& object); // one of the scene
Frame frame_of(const Bounds& bounds);

// How fine: curved primitives are cut until the chord is nearer to the surface than `pixels` as seen from `eye`.
struct TessellationRequest {
    glm::dvec3 eye{0};         // world
    double pixel_angle = 1e-3; // radians that one pixel spans at the image's centre
    double pixels = 0.25;      // chordal error allowed, in pixels
    unsigned subdivide = 0;    // refinement levels for all objects (each quarters every triangle), 0 to 8
    bool normals = true;       // false (flat shading, depth only): vertices need no normals and are shared across creases
    bool detail = false;       // true: meshes with uv get the stream of detail (uv and its gradients)
    bool polygons = true;      // false (nobody asks which polygon): no vertex is doubled to provoke, the stream of polygons is empty
    bool analytic = false;     // true: meshes and polygons only; rays are tested against the other shapes themselves (accel/primitives.h)
    // By object, what it mirrors where that is rendered (plan/cubes.h): surfaces do not share across these.
    std::vector<std::uint32_t> cubes{};
};

// A run of triangles that are near each other: the unit of culling.
struct Cluster {
    std::uint32_t first_index = 0, index_count = 0; // into RasterGeometry::indices
    glm::vec3 center{0};                            // frame
    float radius = 0;
    // Every triangle faces away from `eye` if dot(center - eye, cone_axis) >= cone_cutoff * length(center - eye) + radius. The cutoff is
    // the sine of the half-angle of the cone about cone_axis that holds every face normal, rounded up; 1: cannot be culled by direction.
    glm::vec3 cone_axis{0}; // unit, or 0 with a cutoff of 1
    float cone_cutoff = 1;
    bool two_sided = false; // drawn from both sides: never culled by direction
};

// Streams of points to shade or draw: one PointPosition and one PointNormal each (shaders/shared/layouts.h), index by index.
struct PointStreams {
    std::vector<gpu_layout::PointPosition> positions;
    std::vector<gpu_layout::PointNormal> normals;
    std::vector<gpu_layout::PointDetail> detail; // empty, or one a point; vertices without normals have none
};

// A material as it lies on an object. Where nothing of the material depends on the object, all objects share one surface.
struct Surface {
    std::uint32_t material = 0; // index into Scene::materials
    std::uint32_t object = 0;   // index into Scene::objects; the first that uses it, where they share
    bool operator==(const Surface&) const = default;
};

struct RasterGeometry {
    Frame frame;
    PointStreams vertices;              // vertices.normals is empty if TessellationRequest::normals is false
    std::vector<std::uint32_t> indices; // 3 a triangle; the FIRST vertex of a triangle is its provoking one, and carries its polygon
    PointStreams polygons;              // one a polygon: its centre (mean of its vertices), its face normal, its material; empty
                                        // if TessellationRequest::polygons is false
    std::vector<std::uint32_t> polygon_objects; // object number of each polygon
    std::vector<Surface> surfaces;              // what PointNormal::material counts
    std::vector<std::uint32_t> object_surfaces; // with TessellationRequest::analytic: the surface of each object's own material
    // Opaque one-sided clusters first, then opaque two-sided, translucent one-sided, translucent two-sided; one-sided are culled from behind.
    std::vector<Cluster> clusters;
    std::size_t one_sided_clusters = 0, opaque_clusters = 0; // opaque ones are clusters[0 .. opaque_clusters)
    std::size_t translucent_one_sided_clusters = 0;          // from opaque_clusters on
    std::size_t dropped_degenerate = 0;                      // polygons without area, left out (NI-3)
    std::size_t faces_two_sided = 0;                         // polygons visible from both sides
    bool normals_may_vanish = false; // a triangle has file-given normals that do not all lie on one side of its face (NI-1)
};

// Tessellates every object. `two_sided` of a material decides culling; where it is absent a shape is one-sided iff it is closed and outward.
// An object whose faces have several materials is two-sided if one of them says so, one-sided if all forbid it, else its shape decides,
// as open if a face is translucent. Translucent faces are two-sided unless their own material forbids it.
// Facets of curved primitives and the parts of a subdivided face count as polygons; the caps of cylinders and cones are one each.
// Throws std::length_error with the limit's name if limits::kMaxTriangles is passed.
RasterGeometry tessellate(const Scene& scene, const TessellationRequest& request);

} // namespace lightbench
