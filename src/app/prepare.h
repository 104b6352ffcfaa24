// From a scene file to all that a renderer needs for one view. In: a file and a Request. Out: scene, view, plan, tessellation.
#pragma once

#include "plan/complete.h"
#include "plan/plan.h"
#include "scene/tessellate.h"

#include <filesystem>

namespace lightbench {

// Throws UserError with every problem of the file.
Scene load_or_throw(const std::filesystem::path& file, bool allow_outside = false);

struct Prepared {
    View view;
    Plan plan;
    RasterGeometry geometry;
};

// Completes the scene (camera, light), decides, tessellates, and decides again with what the tessellation told. Throws UserError.
Prepared prepare(Scene& scene, Request request);

} // namespace lightbench
