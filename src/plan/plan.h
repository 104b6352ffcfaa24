// What will run, in which order, on which resources, and why; what will not, and why not. Pure: decided without a GPU.
#pragma once

#include "plan/facts.h"
#include "plan/request.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

// A decision and its reason, one line for people.
struct Line {
    std::string name;
    std::string reason;
};

// Resources and passes are named; the names are the plan's vocabulary, and the GPU objects' debug names.
struct Resource {
    std::string
        name; // "lights", "materials", "vertices", "normals", "polygons", "vertex-colors", "polygon-colors", "depth", "radiance", ...
    std::size_t bytes = 0; // 0: depends on the tessellation (vertices, indices and what is sized by them)
    std::string reason;
};

struct Pass {
    std::string name; // "shade-polygons", "shade-vertices", "raster", "accumulate", "display", "term-..."
    std::string reason;
    std::vector<std::string> reads, writes;
};

struct Plan {
    Method method = Method::raster;
    Shading shading = Shading::phong;
    Precision precision = Precision::float32;
    Output output = Output::pixels;
    glm::uvec2 size{1280, 720};
    Rect crop{}; // the whole image if none was asked for
    float exposure = 0;
    std::uint32_t effects = 0;     // EFFECT_... bits (shaders/shared/effects.h)
    std::uint32_t ray_effects = 0; // RAY_... bits (shaders/shared/rays.h)
    unsigned depth = 5;            // as in the request, like what follows
    float cutoff = 0;
    Structure accel = Structure::bvh;
    AccelParameters accel_parameters{};
    Filter filter = Filter::box;
    float filter_width = 1.5f, filter_sigma = 0.5f;
    Sampling sampling = Sampling::none;
    glm::vec3 contrast{0};
    unsigned max_level = 0;
    RadiosityParameters radiosity{};
    unsigned multisamples = 1; // 1 or 4, per drawn frame
    unsigned frames = 1;       // shifted frames that are averaged
    bool jittered = false;     // their shifts are jittered, else a regular grid
    std::uint32_t seed = 0;
    unsigned subdivide = 0;
    std::uint32_t light_count = 0;        // constant in the pipelines if 1 to kFewLights; 0: read at run time
    std::size_t lights = 0;               // of the scene
    std::optional<std::size_t> triangles; // once tessellated
    std::size_t light_passes = 1;         // the lights are summed in this many bounded pieces
    EnvironmentCubes cubes;               // rendered from objects that mirror; none with a map, or where nothing mirrors
    std::vector<std::string>
        terms; // layers besides the image: "ambient", "diffuse", "specular", "emission", "reflected", "refracted", "background", "shadow", "attenuation", "normal", "depth", "object"
    std::vector<Line> wanted;    // effects that run
    std::vector<Line> skipped;   // effects that do not
    std::vector<Line> fallbacks; // what was put in place of what was missing or cannot be done: camera, light, transmission ...
    std::vector<Pass> passes;
    std::vector<Resource> resources;
    bool runs(std::string_view pass) const;
    bool has(std::string_view resource) const;
    std::size_t colors_of_point() const; // that shading a vertex or a polygon yields: by side, by what textures modulate
};

constexpr std::uint32_t kFewLights = 8; // up to here the loop over lights has a constant end
// A SIMD group of lavapipe has 65 535 loop iterations in all. Points seen from both sides loop twice; half of the budget stays free.
constexpr std::size_t kLightsPerPass = 16384;

// The effects (plan/effects.h) that set a bit of the mask, by name, in the order of the table: for --stats and the tests.
std::vector<std::string> effect_names(const Plan& plan);

// Decides; once with the facts of the file, which says what to tessellate, and again when Facts::geometry is known. `notes` are fallbacks that were decided while the scene was completed (plan/complete.h).
Plan decide(const Facts& facts, const Request& request, std::vector<Line> notes = {});

} // namespace lightbench
