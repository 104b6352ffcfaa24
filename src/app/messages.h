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
    bool shows_progress() const;
    // A bar that grows in its line of a terminal; elsewhere a line now and then. `shown` is the caller's, -1 at first. Nothing at the end of
    // it: clear_bar().
    void bar(double share, int& shown) const;
    void clear_bar(int& shown) const;
    // What was put in place of what the scene lacks or this version cannot draw: nothing is replaced silently.
    void fallbacks(const Plan& plan) const;
};

} // namespace lightbench
