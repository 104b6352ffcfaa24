// What becomes of an effect in the method that was asked for: drawn, replaced by something that the method knows, or left out. Pure.
#pragma once

#include "plan/effects.h"

namespace lightbench {

enum class Fate { drawn, replaced, skipped };

struct Decision {
    Fate fate = Fate::skipped;
    std::string reason;
};
Decision decide_effect(const Effect& effect, const Facts& facts, const Request& request);

// What is drawn where nothing can be solved for: radiosity without light is left to the rasteriser.
Method method_for(const Facts& facts, const Request& request);

} // namespace lightbench
