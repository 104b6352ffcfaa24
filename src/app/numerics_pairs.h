// lightbench numerics --pairs: the table of stable and naive formulas.
#pragma once

#include "measure/numerics/pairs.h"

namespace lightbench {

void print_pairs(gpu::Device& device, const std::vector<kernels::Pair>& pairs, bool quick, bool json);

} // namespace lightbench
