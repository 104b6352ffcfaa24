// render --budget and --max-error: a knob set to what a saved cost.json says fits. In: options as typed. Out: options with the value in them.
#pragma once

#include "app/messages.h"
#include "app/options.h"
#include "gpu/device.h"
#include "measure/report.h"

namespace lightbench {

// As typed; of the last three, empty: not given.
struct BudgetArguments {
    std::optional<std::string> budget, max_error;
    std::string metric, cost, knob;
    bool wanted() const { return budget || max_error; }
};

// What was chosen, and where it was measured.
struct BudgetChoice {
    std::string sentence;     // which, and why
    std::string measured_for; // empty, or a warning: another scene, another size, another view
    std::string device, version;
};

// Puts the value of the knob into `given`. `film`: asked for the size of the scene's own picture where neither --size nor --crop is given.
// Throws UserError: not understood, no such file, knob or metric, or nothing fits, with the nearest offer.
BudgetChoice apply_budget(const BudgetArguments& arguments, Given& given, const std::function<glm::uvec2()>& film);

// A warning if it was measured elsewhere; else empty.
std::string warning_of_device(const BudgetChoice& choice, const gpu::DeviceInfo& device);

} // namespace lightbench
