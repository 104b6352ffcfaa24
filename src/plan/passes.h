// The table of passes: one row each, in the order in which they can run, with what they read and write. Which of them run is decided by
// walking back from the image that is wanted.
#pragma once

#include "plan/plan.h"

#include <string>
#include <vector>

namespace lightbench {

// Every pass that this plan's method, shading and output could have, with reads and writes; plan.effects, .terms, .frames are decided.
// `lit_reads`: what evaluating the illumination model reads besides the geometry, by the effects that are wanted.
std::vector<Pass> candidate_passes(const Plan& plan, const std::vector<std::string>& lit_reads);

// The resource that holds the finished linear image.
std::string image_of(const Plan& plan);

// Keeps those passes of `candidates` that `wanted` (resources) depends on, in their order.
std::vector<Pass> walk_back(std::vector<Pass> candidates, std::vector<std::string> wanted);

} // namespace lightbench
