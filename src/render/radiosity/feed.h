// Lights without area as the first shots of radiosity. In: hemi-cubes, which hold the elements and the structure over them; lights. Out:
// irradiance an element. Inside this room only.
#pragma once

#include "plan/plan.h"
#include "render/gpu_scene.h"
#include "render/radiosity/hemicube.h"

namespace lightbench {

// `count` elements. Submits.
std::vector<glm::vec3> feed(gpu::Device& device, gpu::Recorder& recorder, Hemicubes& hemicubes, std::size_t count, const Plan& plan,
                            GpuScene& scene, gpu::Timings& times);

} // namespace lightbench
