// What mirroring objects see around them (S12, without a map): six views from the middle of each, drawn by the rasteriser without the object
// and without mirrors. In: the completed scene, a plan with its cubes. Out: faces in linear radiance.
#pragma once

#include "gpu/device.h"
#include "image/image.h"
#include "plan/plan.h"

#include <array>

namespace lightbench {

using CubeFaces = std::array<ImageF, 6>; // +X -X +Y -Y +Z -Z, as lib/environment.glsl reads them

struct EnvironmentViews {
    std::vector<CubeFaces> cubes; // as Plan::cubes
    double milliseconds = 0;      // device
};

EnvironmentViews render_environment_cubes(gpu::Device& device, const Scene& scene, const Plan& plan);

} // namespace lightbench
