// What a run tells people while it runs: always on standard error, nothing if they asked for quiet.
#pragma once

#include "app/options.h"
#include "plan/plan.h"

#include <string>

namespace lightbench {

struct Messages {
    bool quiet = false;
    Progress progress = Progress::automatic;
    void say(const std::string& text) const;  // a line, unless quiet
    void step(const std::string& text) const; // a line of progress, if progress is shown
    // What was put in place of what the scene lacks or this version cannot draw: nothing is replaced silently.
    void fallbacks(const Plan& plan) const;
};

} // namespace lightbench
