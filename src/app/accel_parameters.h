// --accel-param: parameters of the acceleration structure. In: text as typed. Out: the parameters, and a sentence for each problem.
#pragma once

#include "plan/request.h"

#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

// "leaf=2", "cells=8,8,4,density=3": a comma before a name ends a parameter, any other is inside of one.
std::vector<std::string> parse_accel_parameters(std::string_view text, Structure structure, AccelParameters& parameters);

} // namespace lightbench
