// Teaching pairs: a stable formula of shaders/lib beside the one of the textbooks (shaders/lib/naive), over the same inputs against the same
// oracle, the naive one in float64 too where the device has it. In: a device. Out: errors and costs of each form.
#pragma once

#include "measure/numerics/inputs.h"

#include "gpu/device.h"
#include "measure/rounds.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lightbench::kernels {

struct Pair {
    std::string name;          // "sphere"
    std::string stable, naive; // functions and what they are, in words
    std::string domain;
    std::string kernel;     // shaders/numerics/pairs/KERNEL.comp, and KERNEL_float64.comp
    std::string no_float64; // why there is no naive form in float64; empty: there is
    std::function<Inputs(std::size_t count, unsigned seed)> inputs;
    std::function<double(std::span<const float>)> expected; // kNoHit of lib/ray.glsl: nothing
    // False where the rounding of the inputs decides what is right: such inputs are not judged.
    std::function<bool(std::span<const float> in, double expected)> sure;
    // Of decisions (1 or 0): how far off the input is from where the wrong decision would be right, relative. Absent: results are numbers.
    std::function<double(std::span<const float>)> distance{};
};

std::vector<Pair> all_pairs();

struct FormErrors {
    double relative = 0, ulp = 0; // the worst of results that are a number as expected; of decisions, the worst distance of a wrong one
    double wrong = 0;             // share of inputs: not finite, hit for miss, miss for hit, the wrong decision
};

struct FormCost {
    // Nanoseconds a call, all invocations of the device together; less the loop without the formula. NaN: lost in the noise of that loop.
    double median = 0, q1 = 0, q3 = 0;
    unsigned runs = 0;
    bool settled = false;
};

struct Form {
    std::string name;    // "stable", "naive", "naive in float64"
    std::string lacking; // why it was not run; empty: it was
    FormErrors errors;
    FormCost cost;
};

struct PairFinding {
    Pair pair;
    std::size_t inputs = 0; // judged
    std::vector<Form> forms;
};

struct PairLimits {
    std::size_t inputs = 1u << 15;      // judged, at most
    std::size_t invocations = 1u << 15; // of a timed run
    double least_milliseconds = 10;     // of a timed run, if turns allow
    RoundLimits rounds{.most = 100, .milliseconds = 8000};
};

PairFinding measure_pair(gpu::Device& device, const Pair& pair, const PairLimits& limits = {});

// For judging one form's results; tests hand in wrong ones.
FormErrors errors_of(const Pair& pair, const Inputs& in, std::span<const float> results);

} // namespace lightbench::kernels
