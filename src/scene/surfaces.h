// How a material lies on an object: which mapping its pictures really have, how that mapping lies in object space, and whether two objects
// may share what is known of the material. In: material, scene, object. Out: Mapping, matrices, surfaces. Pure.
#pragma once

#include "scene/scene.h"
#include "scene/tessellate.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lightbench {

// The opacity t that a method without refraction draws (S13): what would be refracted (S16) goes straight through.
glm::vec3 straight_opacity(const Material& material);

// S13: something behind it is seen through it in some channel.
bool is_translucent(const Material& material);

// Said to be one-sided, and not refracting: rays pass its backs, as the rasteriser culls them. What refracts is left through its backs.
bool hides_backs(const Material& material);

// Is the object a mesh whose vertices have texture coordinates?
bool has_uv(const Scene& scene, const Object& object);

// The mapping that stands in for uv where a shape has none: spherical for spheres and tori, cylindrical for cylinders and cones, planar for
// polygons, boxes and meshes.
Mapping natural_mapping(const Object& object);

// The mapping that the material's texture and bump picture really have on the object: what the texture asks for (uv without one), and the
// natural one in place of uv where the object has none.
Mapping mapping_of(const Scene& scene, const Object& object, const Material& material);

// Does anything of the material depend on where a point lies in object space? Then each object needs a surface of its own.
bool depends_on_object(const Material& material, const Scene& scene, const Object& object);

// Takes object space to mapping space: the shape's bounding box becomes [-1, 1]^3, an axis without extent gets the half extent 1.
// Spherical and cylindrical: z is the polar axis, the shape's own (cylinder, cone, torus) or the object's y; x points away from the front
// (object -z), so that the seam is behind and the middle of a picture in front; of a sphere all half extents are its radius.
// Planar: x and y are the two largest extents, x to the right and y up as seen from the front (a wall: from +z, or from +x if x is the
// flat axis) or from above (a floor). Mapping::uv stands for the natural one.
glm::dmat4 mapping_from_object(const Scene& scene, const Object& object, Mapping mapping);

// Half extents of that box, object units per unit of mapping space: mapping-space points times these are metres of the object.
glm::dvec3 metres_per_mapping_unit(const Scene& scene, const Object& object, Mapping mapping);

// Numbers the surfaces in order of first use. Objects come one after the other.
class SurfaceTable {
  public:
    // `cubes` as in TessellationRequest; it is kept by reference.
    SurfaceTable(const Scene& scene, std::span<const std::uint32_t> cubes);
    std::uint32_t number(std::uint32_t material, std::uint32_t object);
    std::vector<Surface> take() { return std::move(surfaces_); }

  private:
    static constexpr std::uint32_t kUnknown = 0xffffffffu;
    struct Known {
        std::uint32_t object = kUnknown, surface = kUnknown; // the last object that asked, and its answer
        std::uint32_t shared = kUnknown;                     // the surface of all objects that nothing depends on
    };
    std::uint32_t add(std::uint32_t material, std::uint32_t object);
    Known& known(std::uint32_t material, std::uint32_t object);

    const Scene& scene_;
    std::span<const std::uint32_t> cubes_;
    std::size_t cube_count_ = 1;
    std::vector<Known> known_; // one a material and cube
    std::vector<Surface> surfaces_;
};

} // namespace lightbench
