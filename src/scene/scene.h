// The scene as plain data: what a file says, in world space and double precision, before anybody decides how to draw it.
// In: loaders and `make`. Out: facts, tessellation, upload. Knows nothing of Vulkan.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace lightbench {

// --- lights -----------------------------------------------------------------------------------------------------------------------

enum class LightType : std::uint32_t { point, directional, spot };
enum class Attenuation : std::uint32_t { none, linear, inverse_square };

// S4, S5. A directional light is never attenuated, whatever its law says.
struct Light {
    LightType type = LightType::point;
    glm::dvec3 position{0};         // metres; point and spot
    glm::dvec3 direction{0, -1, 0}; // unit, the way the light travels; directional and spot
    glm::vec3 intensity{1};         // Ip = color * intensity, irradiance over pi, >= 0
    Attenuation attenuation = Attenuation::linear;
    double d0 = 1;         // metres, > 0; the linear law only
    double angle = 0.5;    // radians, half-angle of a spot's cone, (0, pi/2]
    double softness = 0.1; // fraction of the cone that fades, [0, 1]
};

// --- materials --------------------------------------------------------------------------------------------------------------------

enum class Model : std::uint32_t { phong, cook_torrance };
enum class Distribution : std::uint32_t { gaussian, beckmann };
enum class Mapping : std::uint32_t { uv, spherical, cylindrical, planar };
enum class Wrap : std::uint32_t { repeat, clamp, mirror };
enum class BumpFunction : std::uint32_t { none, waves, noise };

// An encoded picture (PNG, JPEG, HDR): a file, or bytes embedded in an imported file. Decoded only when the plan reads it.
struct Picture {
    std::filesystem::path file;
    std::vector<unsigned char> encoded; // not empty: embedded, and `file` only names it
    bool operator==(const Picture&) const = default;
};

struct Texture {
    std::optional<std::uint32_t> picture; // index into Scene::pictures; none: the checker
    Mapping mapping = Mapping::uv;
    glm::dvec2 scale{1}; // repeats
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    bool alpha = false; // the picture's alpha multiplies the opacity
    bool operator==(const Texture&) const = default;
};

struct Bump {
    std::optional<std::uint32_t> picture; // height image, or a normal map if `normal_map`
    bool normal_map = false;
    BumpFunction function = BumpFunction::none;
    double amplitude = 0.01; // metres
    double frequency = 1;    // per metre
    bool operator==(const Bump&) const = default;
};

struct Material {
    std::string name;
    glm::vec3 diffuse{0.8f}; // kd, [0, 1]
    glm::vec3 specular{0};   // ks, [0, 1]
    float shininess = 32;    // Phong exponent n, >= 0, finite
    Model model = Model::phong;
    Distribution distribution = Distribution::gaussian;
    float roughness = 0.3f;              // rms slope m, > 0
    glm::vec3 ior{1.5f};                 // index of refraction per channel, > 0
    std::optional<glm::vec3> f0;         // reflectance at normal incidence, [0, 1); wins over ior for highlights
    bool fresnel = false;                // Fresnel split of reflection and transmission (S16)
    std::optional<glm::vec3> reflection; // kr, [0, 1]; specular when absent
    glm::vec3 transmission{0};           // kt, [0, 1], refracted (S16)
    float scatter = 0;                   // rms slope of frosted surfaces (S17), >= 0
    glm::vec2 dispersion{0};             // Cauchy A, B (micrometres^2); B = 0: none
    glm::vec3 opacity{1};                // t, [0, 1]; 1 opaque (S13)
    glm::vec3 emission{0};               // radiance, >= 0
    std::optional<bool> two_sided;       // absent: false for closed shapes, true for open ones
    float environment = 0;               // weight of environment mapping, [0, 1]
    std::optional<Texture> texture;
    std::optional<Bump> bump;
    bool operator==(const Material&) const = default;
};

// --- shapes, in object space ----------------------------------------------------------------------------------------------------------

struct Sphere {
    glm::dvec3 center{0};
    double radius = 1;
}; // radius > 0
struct Polygon {
    std::vector<glm::dvec3> points;
    std::vector<glm::vec3> normals;
}; // >= 3 points, planar, maybe concave; normals empty or one a point
struct Box {
    glm::dvec3 min{-0.5}, max{0.5};
}; // min < max in each axis
struct Cylinder {
    glm::dvec3 base{0}, top{0, 1, 0};
    double radius = 0.5;
    bool capped = true;
};
struct Cone {
    glm::dvec3 base{0}, top{0, 1, 0};
    double base_radius = 0.5, top_radius = 0;
    bool capped = true;
}; // radii >= 0, not both 0
struct Torus {
    glm::dvec3 center{0}, axis{0, 1, 0};
    double major = 1, minor = 0.25;
}; // major, minor > 0
struct MeshUse {
    std::uint32_t mesh = 0;
}; // index into Scene::meshes

using Shape = std::variant<Sphere, Polygon, Box, Cylinder, Cone, Torus, MeshUse>;

// Faces are polygons (n-gons stay whole: flat shading's centre is the mean of all n vertices), counter-clockwise seen from outside.
// Face f has the corners corners[face_starts[f]] ... corners[face_starts[f + 1] - 1], each an index of a vertex.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  // empty, or one a vertex (the file's own: kept), unit
    std::vector<glm::vec2> uvs;      // empty, or one a vertex; v grows upwards in the picture (OBJ's way; loaders turn others)
    std::vector<glm::vec4> tangents; // empty, or one a vertex: unit, the way of u; w the sign of the way of v (glTF's TANGENT)
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> face_starts;    // faces + 1 entries, the first 0
    std::vector<std::uint32_t> face_materials; // empty: the object's material; else one a face, index into Scene::materials
    std::size_t face_count() const { return face_starts.empty() ? 0 : face_starts.size() - 1; }
};

struct Object {
    Shape shape;
    std::uint32_t material = 0;  // index into Scene::materials
    std::uint32_t transform = 0; // index into Scene::transforms, world_from_object; 0 is the identity
    float crease = 0.5235988f;   // radians; edges sharper than this stay sharp where normals are computed (30 degrees)
    std::uint8_t subdivide = 0;  // further refinement levels of this object, 0 to 8
};

// --- the rest ----------------------------------------------------------------------------------------------------------------------

struct Camera {
    std::string name;
    glm::dvec3 position{0, 0, 5};
    glm::dvec3 target{0};
    glm::dvec3 up{0, 1, 0};
    double fov = 0.7853981633974483; // radians, vertical, (0, pi)
    double hither = 0;               // metres; nothing nearer is seen
    // Square pixels are the rule; NFF and TOML may fix a size.
};

struct Environment {
    glm::vec3 background{0};        // radiance of rays that leave the scene, >= 0
    glm::vec3 ambient{0};           // Ia, >= 0
    std::vector<std::uint32_t> map; // pictures: empty, one equirectangular, or six faces +X -X +Y -Y +Z -Z
};

struct Scene {
    std::string name;               // file name, for people
    std::optional<glm::uvec2> film; // pixels
    std::vector<Camera> cameras;    // empty: one is fitted (a plan line)
    Environment environment;
    std::vector<Light> lights;       // empty: a headlight (a plan line)
    std::vector<Material> materials; // never empty once loaded
    std::vector<glm::dmat4> transforms{glm::dmat4(1)};
    std::vector<Mesh> meshes;
    std::vector<Picture> pictures;
    std::vector<Object> objects;
    std::vector<std::string> remarks; // what the loader could not express, one plan line each ("OBJ Ka is not used: ...")
};

} // namespace lightbench
