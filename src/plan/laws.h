// What options put in the place of a scene's own laws: the local model of its materials, the attenuation of its lights.
#pragma once

#include "plan/plan.h"

namespace lightbench {

// Request::model and Request::attenuation; a line for each that was asked for.
std::vector<Line> replace_laws(Scene& scene, const Request& request);

} // namespace lightbench
