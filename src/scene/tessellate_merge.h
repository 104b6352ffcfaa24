// Makes one vertex of those that agree bit by bit, across objects: the patches of a polygon file then share what they were split from.
#pragma once

#include "scene/tessellate_provoke.h"

namespace lightbench {

void merge_vertices(RasterGeometry& geometry, Soups& soups);

} // namespace lightbench
