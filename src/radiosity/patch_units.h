// Which units of a cutting are sent from together. In: pieces in units, their faces, groups, how large a patch may be. Out: the patch of
// each unit. Pure.
#pragma once

#include "radiosity/cut.h"

namespace lightbench {

// A number a unit: equal for those of a patch, that of its first unit. Units smaller than a patch are gathered, neighbour by neighbour,
// about the first of them: those of one group whose middle is no farther than half of `patch` (frame units) from its middle, and that turn
// from it by 45 degrees at most. `groups`: a number a face.
std::vector<std::uint32_t> gather_units(const BaseMesh& base, const Cutting& cutting, const std::vector<std::uint32_t>& groups,
                                        double patch);

} // namespace lightbench
