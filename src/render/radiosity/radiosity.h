// Radiosity (S27 to S32): a scene cut into elements, its light solved for, and drawn from anywhere. In: scene, plan. Out: a solution that grows
// shot by shot, and the drawing of it.
#pragma once

#include "image/image.h"
#include "plan/complete.h"
#include "render/radiosity/solution.h"
#include "render/raster.h"
#include "render/render.h"

namespace lightbench {

struct RadiosityParts;

// Owns the elements, the hemi-cubes and the state of the solver on the device, which outlives it.
class Radiosity {
  public:
    // Throws gpu::EnvironmentError; FileError if there would be too many elements.
    Radiosity(gpu::Device& device, const Scene& scene, const Plan& plan, GpuScene& gpu_scene);
    Radiosity(Radiosity&&) noexcept;
    ~Radiosity();

    // Goes on where another run stopped. FileError if it is of another scene or other parameters.
    void resume(const RadiositySolution& solution, const std::string& name);
    RadiositySolution solution();

    // Forgets what was solved; what was fed stays.
    void restart();

    // One submission of shots, or the full matrix. False: there is nothing left to do.
    bool advance(gpu::Recorder& recorder, gpu::Timings& times);
    const RadiosityStatistics& statistics() const;

    // In place of the light: what Plan::radiosity asks to be shown, as colors of what is drawn, or as a picture. Submits.
    std::optional<ImageF> show(gpu::Recorder& recorder, gpu::Timings& times, const View& view, glm::uvec2 size);

    // Brings the colors that are drawn up to what is solved.
    void update_colors();
    // Draws all elements; returns the number of triangles.
    std::size_t record_draw(gpu::Recorder& recorder, const RasterDraw& draw, gpu::RenderTargets targets);

  private:
    std::unique_ptr<RadiosityParts> parts_;
};

} // namespace lightbench
