// A knob turned through its values: pictures, errors, times in rounds. The renderer is behind functions, so that a test may put another in its
// place.
#pragma once

#include "image/image.h"
#include "measure/knobs.h"
#include "measure/report.h"
#include "measure/rounds.h"

#include <functional>

namespace lightbench {

// One run of one variant.
struct Rendering {
    ImageF radiance;
    double milliseconds = 0; // device timestamps
};

struct References {
    ImageF first, second; // the second says how sure the first is
};

struct SweepRunner {
    std::function<Rendering(std::size_t)> run;                       // variant i, from the beginning
    std::function<void(std::size_t, const Rendering&)> take_picture; // of the first run, which is not timed: drivers compile then
    std::function<double()> wall;                                    // milliseconds
    std::function<bool()> stop = {};                                 // asked after each run; true: that run counts no more
};

struct Swept {
    CostCurve curve;
    std::size_t broken = 0; // expectations, each a note of the curve
    bool stopped = false;   // before every value was timed once: the curve is none
};

// `planned`: the curve as far as it is known before it is measured; its points have a value, an image and a command.
Swept sweep(CostCurve planned, const Knob& knob, const References& references, const SweepRunner& runner, const RoundLimits& limits,
            float exposure = 0);

} // namespace lightbench
