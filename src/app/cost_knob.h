// One knob of `lightbench cost`, from its values to a measured curve with its pictures on disk.
#pragma once

#include "app/cost_folder.h"
#include "app/messages.h"
#include "app/options.h"
#include "measure/sweep.h"
#include "render/render.h"

namespace lightbench {

// A knob whose values and references are all understood.
struct PlannedKnob {
    const Knob* knob = nullptr;
    OptionTexts base;
    std::vector<std::string> values;
    std::vector<SceneOptions> variants; // one a value
    std::array<OptionTexts, 2> reference_texts;
    std::array<SceneOptions, 2> references;
    std::vector<std::string> overridden; // typed options in whose place a value puts its own
};

// All problems of the values, before anything is rendered. `base`: the user's options and the size of the pictures.
PlannedKnob plan_knob(const KnobUse& use, const Scene& scene, OptionTexts base, Problems& problems);

// What is known of its curve before it is measured: names, commands, pictures, no numbers.
CostCurve planned_curve(const PlannedKnob& planned);

struct KnobRun {
    gpu::Device& device;
    const Scene& scene;
    ReportFolder& folder;
    RoundLimits limits;
    Messages messages;
};

// Renders, measures, writes the pictures; an Interrupt ends it early, and takes them away if nothing was measured. Throws UserError, gpu::EnvironmentError, FileError.
Swept measure_knob(PlannedKnob planned, const KnobRun& run);

} // namespace lightbench
