// Materials as the shaders read them: one a surface, in the frame's units, with the pictures of all of them in one table of texels.
// In: scene, surfaces, plan, the faces of its cubes. Out: plain data to upload. FileError for a picture that cannot be read (image/files.h).
#pragma once

#include "image/texels.h"
#include "plan/plan.h"
#include "render/environment_cube.h"
#include "scene/tessellate.h"

namespace lightbench {

// FileError if it cannot be read, or holds what is not finite.
AnyImage decode_picture(const Picture& picture);

struct MaterialTables {
    std::vector<gpu_layout::Material> materials; // by surface; a single one where the plan says that all are alike
    TexelTable texels;                           // pictures of textures, bumps, the environment: only those that the plan draws
    gpu_layout::TexelInfo environment{};         // six faces: height is the number of uvec4s of each
};

MaterialTables material_tables(const Scene& scene, const RasterGeometry& geometry, const Plan& plan, std::span<const CubeFaces> cubes = {});

} // namespace lightbench
