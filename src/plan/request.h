// What the user asked for: the options of the command line, checked for range but not yet held against the scene.
#pragma once

#include "scene/edit.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace lightbench {

enum class Method { raster, raytrace, radiosity };
enum class Shading { flat, gouraud, phong };
enum class Precision { float32, float64 }; // of Phong's terms, where the rasteriser evaluates them at each pixel
enum class Sampling { none, uniform, jittered, adaptive };
enum class Filter { box, gaussian };
enum class Structure { none, bvh, sphere_bvh, grid, octree }; // as ACCEL_... (shaders/shared/rays.h)
enum class Output { pixels, radiance };                       // display-referred 8 bit (PNG), or linear radiance (EXR)

struct Rect {
    glm::uvec2 offset{0}, size{0};
    bool operator==(const Rect&) const = default;
}; // pixels, origin at the upper left

enum class TreeBuilder { host, device };

// 0: chosen by what builds the structure.
struct AccelParameters {
    TreeBuilder builder = TreeBuilder::host; // bvh
    unsigned leaf = 0;                       // primitives of a leaf at most (bvh, sphere-bvh), of a voxel before it is split (octree)
    glm::uvec3 cells{0};                     // of the grid
    double density = 0;                      // cells of the grid a primitive
    unsigned depth = 0;                      // of the octree at most
    bool operator==(const AccelParameters&) const = default;
};

enum class Solver { progressive, full };
enum class Show { light, patches, form_factors, hemicube }; // of radiosity

// 0: chosen by what cuts the surfaces.
struct RadiosityParameters {
    unsigned hemicube = 64;        // pixels along an edge, even, 8 to 1024
    double patch = 0, element = 0; // metres: longest edges
    Solver solver = Solver::progressive;
    std::optional<unsigned> shots; // at most; absent: until that little is unshot
    double until = 0.001;          // of what is emitted, (0, 1)
    bool ambient = true;           // S31, for display only
    Show show = Show::light;
    std::optional<glm::uvec2> pick; // pixel whose patch is shown
    bool feed = false;              // lights without area feed scenes that glow, too
    bool correct_near = true;       // analytic form factors where a hemi-cube is wrong (Baum, Rushmeier, Winget 1989)
    bool operator==(const RadiosityParameters&) const = default;
};

inline bool operator==(const Camera& a, const Camera& b) {
    return a.name == b.name && a.position == b.position && a.target == b.target && a.up == b.up && a.fov == b.fov && a.hither == b.hither;
}

struct Request {
    Method method = Method::raster;
    Shading shading = Shading::phong;
    Precision precision = Precision::float32;
    std::optional<glm::uvec2> size;         // absent: the scene's [film], else 1280x720
    std::optional<Rect> crop;               // inside the image
    std::string camera;                     // name; empty: the first
    std::optional<Camera> placed;           // of the user's own, in the place of the scene's
    std::optional<int> frame;               // of the turntable
    unsigned subdivide = 0;                 // 0 to 8
    std::optional<Model> model;             // in the place of the materials' own
    std::optional<Attenuation> attenuation; // in the place of the lights' own
    Sampling sampling = Sampling::none;
    unsigned spp = 1; // samples a pixel, a square, 1 to 1024
    std::uint32_t seed = 0;
    float exposure = 0; // stops
    Output output = Output::pixels;
    bool terms = false; // one layer a term (EXR only)
    bool count = false; // rays and tests are counted

    // Rays only.
    unsigned depth = 5;          // levels of the ray tree, the eye ray the first; 1 to 255
    float cutoff = 0;            // rays of a smaller weight are not sent; 0: none is too small
    bool opaque_shadows = false; // what one can see through casts shadows all the same
    Structure accel = Structure::bvh;
    AccelParameters accel_parameters{};
    Filter filter = Filter::box;
    float filter_width = 1.5f, filter_sigma = 0.5f; // of the Gaussian: radius and sigma, pixels
    glm::vec3 contrast{0.25f, 0.2f, 0.4f};          // S26
    unsigned max_level = 2;                         // of adaptive sampling: a pixel is split in 4 at most so many times

    RadiosityParameters radiosity;
    SceneEdits edits; // before anything is decided
    bool operator==(const Request&) const = default;
};

} // namespace lightbench
