// Counts and booleans about a scene: all that deciding needs to know of it. Pure.
#pragma once

#include "plan/cubes.h"
#include "scene/scene.h"

#include <array>
#include <cstddef>
#include <optional>

namespace lightbench {

struct RasterGeometry;

// Of radiosity: the series of what walls send each other needs 1 / (1 - rho) as many terms.
constexpr float kMostReflectance = 0.999f;

// What only the tessellation tells.
struct GeometryFacts {
    std::size_t vertices = 0, triangles = 0, polygons = 0, surfaces = 0;
    std::size_t faces_two_sided = 0, dropped_degenerate = 0;
    bool normals_may_vanish = false;
};

struct Facts {
    std::size_t objects = 0, spheres = 0, polygons = 0, boxes = 0, cylinders = 0, cones = 0, tori = 0, mesh_objects = 0, mesh_faces = 0;
    std::size_t lights = 0, point_lights = 0, directional_lights = 0, spot_lights = 0; // of intensity > 0
    std::size_t unattenuated_lights = 0, linear_lights = 0, inverse_square_lights = 0; // of the positional ones
    std::size_t materials = 0;                                                         // that an object uses
    std::size_t materials_listed = 0;                                                  // that the scene has
    std::size_t diffuse_materials = 0, specular_materials = 0, emissive_materials = 0;
    std::size_t white_materials = 0;                                                 // with kd above kMostReflectance in a channel
    std::size_t phong_materials = 0, gaussian_materials = 0, beckmann_materials = 0; // with ks > 0
    std::size_t picture_materials = 0, checker_materials = 0, alpha_materials = 0;   // with such a texture
    std::size_t wave_materials = 0, noise_materials = 0, height_materials = 0, normal_map_materials = 0; // with such a bump
    std::size_t environment_materials = 0;                                                               // that mirror it
    std::array<std::size_t, 4> mappings{}; // objects whose texture or bump picture is mapped so, by Mapping
    std::size_t smooth_lobes = 0;          // Cook-Torrance below the least roughness
    std::size_t translucent_materials = 0; // opacity < 1 in a channel (S13), transmission counted in
    std::size_t transmissive_materials = 0, reflective_materials = 0, scattering_materials = 0, dispersive_materials = 0;
    std::size_t tinted_materials = 0;    // transmissive, with indices of refraction that differ by channel
    std::size_t one_sided_materials = 0; // said to be so: their backs are not seen
    std::size_t clear_materials = 0;     // opacity < 1, or the alpha of a picture: S13 alone
    std::size_t mirror_materials = 0;    // that name a reflection > 0 and no environment in its place; the others reflect ks
    std::size_t fresnel_materials = 0;   // Fresnel split of reflection and transmission
    std::size_t two_sided_objects = 0;   // some face is seen from behind
    std::size_t pictures = 0;
    bool ambient = false, background = false, environment_map = false, six_faces = false, camera = false, film = false;
    bool headlight = false;                // the only light was added to a scene without any
    bool own_normals = false;              // some mesh or polygon came with normals
    std::optional<EnvironmentCubes> cubes; // of a scene without a map, once the view is known
    std::optional<GeometryFacts> geometry; // once tessellated
};

Facts gather_facts(const Scene& scene);

// What depends on where one stands. The scene is completed.
void add_view(Facts& facts, const Scene& scene, const View& view);

// Decided without these, a plan errs to the safe side: a mesh may be open, its own normals may vanish between vertices.
void add_geometry(Facts& facts, const RasterGeometry& geometry);

} // namespace lightbench
