// Which clusters of triangles a view can see, as few runs of indices as possible. Pure.
#pragma once

#include "scene/tessellate.h"

#include <span>
#include <vector>

namespace lightbench {

struct IndexRun {
    std::uint32_t first = 0, count = 0;
};

// Runs in index order: clusters outside the frustum are left out, and one-sided ones that face away from the eye.
// Never leaves out a triangle that would cover a sample. `clip_from_frame` has reversed z and an infinite far plane.
std::vector<IndexRun> visible_runs(std::span<const Cluster> clusters, const glm::mat4& clip_from_frame, glm::vec3 eye);

} // namespace lightbench
