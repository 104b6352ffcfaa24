// Our side: the program's own structure, pipelines and bindings for rays that are handed in. In: a scene, rays. Out: distances, device time.
#pragma once

#include "rays.h"
#include "render/ray_pipelines.h"

#include <span>

namespace lightbench {

class OurScene {
  public:
    // One light only, at `light` (world).
    OurScene(gpu::Device& device, Scene made, const glm::dvec3& light, glm::uvec2 size);
    // As trace.comp and shadow.comp run in a frame. Rays lie on the device already when the time begins.
    double trace(std::span<const BenchRay> rays, Travel travel, Distances& distances);

    const View& view() const { return view_; }
    const RasterGeometry& geometry() const { return geometry_; }
    RayPrimitives primitives() const { return ray_primitives(scene_, geometry_); } // by number
    const AccelTables& accel() const { return tracer_.scene.accel; }

  private:
    double trace_batch(std::span<const BenchRay> rays, Travel travel, float* distances);
    double submit(std::string_view pass, std::uint32_t count, std::uint32_t& hits);
    gpu::Bindings structure(gpu::Bindings bindings);

    gpu::Device& device_;
    Scene scene_;
    View view_;
    Plan plan_;
    RasterGeometry geometry_;
    GpuScene on_gpu_;
    RayTracer tracer_;
    gpu::Recorder recorder_;
    gpu::Timings times_;
};

} // namespace lightbench
