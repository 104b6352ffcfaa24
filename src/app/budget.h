// render --budget and --max-error: a knob set to what a saved cost.json says fits. In: options as typed. Out: options with the value in them.
#pragma once

#include "app/messages.h"
#include "app/options.h"
#include "gpu/device.h"
#include "measure/report.h"

namespace lightbench {

// As typed; empty: not given.
struct BudgetArguments {
    std::string budget, max_error, metric, cost, knob;
    bool wanted() const { return !budget.empty() || !max_error.empty(); }
};

// What was chosen, and where it was measured.
struct BudgetChoice {
    std::string sentence;     // which, and why
    std::string measured_for; // empty, or a warning: another scene, another size
    std::string device, version;
};

// Puts the value of the knob into `given`. Throws UserError: not understood, no such file, knob or metric, or nothing fits, with the nearest offer.
BudgetChoice apply_budget(const BudgetArguments& arguments, Given& given);

// A warning if it was measured elsewhere; else empty.
std::string warning_of_device(const BudgetChoice& choice, const gpu::DeviceInfo& device);

} // namespace lightbench
