// A plan for people and for programs: what runs and why, what does not and why not, on which resources.
#pragma once

#include "plan/plan.h"

#include <string>

namespace lightbench {

std::string explain(const Plan& plan);      // text, lines end with \n
std::string explain_json(const Plan& plan); // one JSON object, indented, ends with \n

std::string_view name_of(Method method);
std::string_view name_of(Shading shading);

} // namespace lightbench
