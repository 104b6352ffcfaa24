// The one place that runs a plan. In: a completed scene, its tessellation, the plan, a view. Out: pixels or radiance, layers, times.
#pragma once

#include "gpu/device.h"
#include "image/image.h"
#include "plan/complete.h"
#include "scene/tessellate.h"

#include <functional>
#include <memory>
#include <optional>

namespace lightbench {

struct Layer {
    std::string name;
    ImageF image; // the crop
};

struct StepTime {
    std::string name;
    double milliseconds = 0; // device; summed over the frames of one image
};

// Of --count: rays by kind, tests by primitive, nodes and voxels visited.
struct RayStatistics {
    std::uint64_t eye = 0, eye_hit = 0, shadow = 0, reflected = 0, refracted = 0, straight = 0;
    std::uint64_t nodes = 0, voxels = 0, triangles = 0, spheres = 0, boxes = 0, balls = 0, cones = 0, tori = 0;
};

// What building the structure took.
struct AccelStatistics {
    double milliseconds = 0;
    std::size_t bytes = 0, nodes = 0, references = 0;
    std::uint32_t depth = 0;
};

// Of --method radiosity.
struct RadiosityStatistics {
    std::size_t patches = 0, elements = 0;
    std::uint64_t shots = 0;  // full matrix: sweeps
    double unshot = 1;        // share of what is emitted
    double closure_error = 0; // largest |1 - sum of a row|
    double milliseconds = 0;  // device, of solving
    struct Point {
        std::uint64_t shots = 0;
        double unshot = 1, milliseconds = 0;
    };
    std::vector<Point> curve; // one a submission
};

struct RenderOutput {
    std::optional<Image8> pixels;   // Output::pixels; the crop
    std::optional<ImageF> radiance; // Output::radiance; the crop
    std::vector<Layer> layers;      // Plan::terms
    std::uint64_t non_finite = 0;   // pixels of the crop with a NaN or an infinity, counted before any clamp
    std::vector<StepTime> times;    // of the image; not of the layers
    double device_milliseconds = 0;
    std::size_t triangles_drawn = 0;   // after culling
    std::optional<RayStatistics> rays; // with Request::count
    std::optional<AccelStatistics> accel;
    std::optional<RadiosityStatistics> radiosity;
    bool stopped = false; // radiosity: before the plan was met; the image is whole all the same
    double done = 1;      // share of the image; below 1 only if it was stopped
};

struct RenderOptions {
    // Runs everything once before the run that is timed: drivers compile at the first draw. Left out if that first run passes a second.
    bool warm_up = false;
    // Of --method raytrace and radiosity; each may be empty.
    std::function<void(double)> progress; // the share that is done, now and then
    std::function<bool()> stop;           // asked now and then; true: what there is becomes the image, black where there is nothing
    std::function<void(const RenderOutput&)> pass; // the image so far, after every frame but the last; of radiosity, now and then
    bool anew = false;    // of --method radiosity: what an earlier render() solved is forgotten, so that this one can be timed
    std::string solution; // of --method radiosity: a file that it goes on from, if there is one, and that keeps it
};

// What the plan needs of the tessellation: streams that nobody reads are not made.
TessellationRequest tessellation_for(const Plan& plan, const View& view);

struct RendererState;

// Owns the GPU side of one scene under one plan: buffers, pipelines, targets. The device outlives it.
class Renderer {
  public:
    Renderer(gpu::Device& device, const Scene& scene, const RasterGeometry& geometry, const Plan& plan);
    Renderer(Renderer&&) noexcept;
    ~Renderer();
    // Throws gpu::EnvironmentError.
    RenderOutput render(const View& view, const RenderOptions& options = {});

  private:
    std::unique_ptr<RendererState> state_;
};

} // namespace lightbench
