// What the numbers of a curve mean: its fronts, how steeply errors fall, and which expectations they break. Pure.
#pragma once

#include "measure/knobs.h"
#include "measure/report.h"

namespace lightbench {

// Marks the fronts, fits slopes and adds notes to a curve whose points are measured. Returns how many expectations are broken: an error that
// rises by more than the reference is uncertain where it should fall, or a reference that says nothing of that; a slope that holds of all
// scenes, and not here; a picture that differs where all must be equal.
std::size_t conclude(CostCurve& curve, const Knob& knob);

// Says of which points the median is not sure enough, and why. Those without a time are left out.
void note_unsettled(CostCurve& curve);

} // namespace lightbench
