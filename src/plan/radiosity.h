// When a scene calls for radiosity, and the passes of it. Pure.
#pragma once

#include "plan/effects.h"
#include "plan/plan.h"

namespace lightbench {

// Wanted if something sends light and something diffuse sends it on.
Verdict radiosity_verdict(const Facts& facts, const RadiosityParameters& parameters);

// What of the effects radiosity knows: emission, and lights as first shots. "" if it knows this one, else why it is left out.
std::string left_out_by_radiosity(std::string_view effect, const Facts& facts, const RadiosityParameters& parameters);

std::vector<Pass> radiosity_passes(const Plan& plan);

// What is put in place of what cannot be had: parameters that do not go together.
void note_radiosity(const Facts& facts, Plan& plan);

} // namespace lightbench
