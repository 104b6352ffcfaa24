// Pairs on the device: every form once over the inputs for its errors, then all of them in turn, with an empty loop, for their costs.
#include "measure/numerics/pairs.h"

#include "gpu/buffer.h"
#include "gpu/check.h"
#include "gpu/float64.h"
#include "gpu/recorder.h"
#include "measure/numerics/rays.h"
#include "measure/numerics/run_kernel.h"
#include "measure/statistics.h"

#include <chrono>

namespace lightbench::kernels {

namespace {

constexpr std::uint32_t kGroup = 64;      // invocations, as in pair.glsl
constexpr std::uint32_t kMostCalls = 256; // Mesa 22's lavapipe ends a shader's loops after 65 535 turns in all; a torus takes 200 of them
enum FormOf : std::uint32_t { kEmpty, kStable, kNaive };

struct PairPush {
    std::uint32_t count, calls;
};

struct Bench {
    gpu::Device& device;
    gpu::Buffer arguments, results;
    std::uint32_t count;
};

Bench make_bench(gpu::Device& device, const Inputs& in) {
    constexpr auto kStorage = vk::BufferUsageFlagBits::eStorageBuffer;
    return {device, gpu::make_filled_buffer(device, "arguments", std::span(in.values), kStorage),
            gpu::make_buffer(device, "results", in.count() * 2 * sizeof(float), kStorage), static_cast<std::uint32_t>(in.count())};
}

// Milliseconds on the device.
double run_form(Bench& bench, const gpu::ComputePipeline& pipeline, std::uint32_t calls) {
    gpu::Recorder recorder(bench.device);
    recorder.compute("pair", pipeline, {{"Arguments", bench.arguments}, {"Results", bench.results}}, PairPush{bench.count, calls},
                     {(bench.count + kGroup - 1) / kGroup});
    return recorder.submit_and_wait().at(0).milliseconds;
}

// A result of every invocation after `calls` turns; CHECKs that all of them were made.
std::vector<float> results_of(Bench& bench, std::uint32_t calls) {
    const std::vector<float> both = gpu::download_all<float>(bench.device, bench.results);
    std::vector<float> results;
    for (std::size_t i = 0; i < both.size(); i += 2) {
        CHECK(both[i + 1] == static_cast<float>(calls));
        results.push_back(both[i]);
    }
    return results;
}

struct Runnable {
    std::size_t form; // of the finding; the empty loop has none
    gpu::ComputePipeline pipeline;
};

gpu::ComputePipeline pipeline_of(gpu::Device& device, const Pair& pair, FormOf form, bool float64) {
    const gpu::ShaderCode& code = find_kernel(fmt::format("pairs/{}{}", pair.kernel, float64 ? "_float64" : ""));
    return gpu::make_compute(device, code, {{0, form}}, sizeof(PairPush));
}

std::vector<Runnable> runnables(gpu::Device& device, const Pair& pair, std::vector<Form>& forms) {
    forms = {{"stable", {}, {}, {}}, {"naive", {}, {}, {}}, {"naive in float64", pair.no_float64, {}, {}}};
    if (!gpu::has_float64(device)) forms[2].lacking = "the device has no float64";
    std::vector<Runnable> all;
    all.push_back({0, pipeline_of(device, pair, kStable, false)});
    all.push_back({1, pipeline_of(device, pair, kNaive, false)});
    if (forms[2].lacking.empty()) all.push_back({2, pipeline_of(device, pair, kNaive, true)});
    return all;
}

// Turns that make a run of the stable form long enough for the clock.
std::uint32_t calls_for(Bench& bench, const gpu::ComputePipeline& stable, double least) {
    std::uint32_t calls = 1;
    while (calls < kMostCalls && run_form(bench, stable, calls) < least) calls *= 2;
    return calls;
}

double wall_milliseconds() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Each run less the empty loop of the same round. Where that is not above 0 for three quarters of the runs, nor surely for the median of them,
// nothing is known of the formula's cost.
FormCost cost_of(const Timed& timed, double nanoseconds) {
    constexpr double kLost = std::numeric_limits<double>::quiet_NaN();
    const Quartiles q = quartiles(timed.milliseconds);
    const auto runs = static_cast<unsigned>(timed.milliseconds.size());
    const auto sure = median_interval(timed.milliseconds);
    if (q.q1 <= 0 && !(sure && sure->low > 0)) return {kLost, kLost, kLost, runs, false};
    return {q.median * nanoseconds, q.q1 * nanoseconds, q.q3 * nanoseconds, runs, timed.settled};
}

void time_forms(Bench& bench, const Pair& pair, const std::vector<Runnable>& all, std::vector<Form>& forms, const PairLimits& limits) {
    const gpu::ComputePipeline empty = pipeline_of(bench.device, pair, kEmpty, false);
    const std::uint32_t calls = calls_for(bench, all.front().pipeline, limits.least_milliseconds);
    const auto run = [&](std::size_t i) { return run_form(bench, i == 0 ? empty : all[i - 1].pipeline, calls); };
    run(0); // the first dispatch may compile
    RoundLimits rounds = limits.rounds;
    rounds.net = true;
    const std::vector<Timed> timed = time_in_rounds(all.size() + 1, run, wall_milliseconds, rounds);
    const double nanoseconds = 1e6 / (static_cast<double>(bench.count) * calls);
    for (std::size_t i = 0; i < all.size(); ++i) forms[all[i].form].cost = cost_of(timed[i + 1], nanoseconds);
}

bool is_miss(double x) {
    return x == kNoHit;
}

} // namespace

FormErrors errors_of(const Pair& pair, const Inputs& in, std::span<const float> results) {
    FormErrors errors;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < in.count(); ++i) {
        const double expected = pair.expected(in[i]), got = static_cast<double>(results[i]);
        const float magnitude = static_cast<float>(std::abs(expected));
        const double off = std::abs(got - expected),
                     ulp = static_cast<double>(std::nextafter(magnitude, std::numeric_limits<float>::infinity()) - magnitude);
        if (pair.distance && got != expected) {
            ++wrong;
            errors.relative = std::max(errors.relative, pair.distance(in[i]));
        } else if (!std::isfinite(got) || is_miss(got) != is_miss(expected)) {
            ++wrong;
        } else if (off > 0 && expected != 0 && magnitude >= std::numeric_limits<float>::min()) {
            errors.relative = std::max(errors.relative, off / std::abs(expected));
            errors.ulp = std::max(errors.ulp, off / ulp);
        }
    }
    errors.wrong = static_cast<double>(wrong) / static_cast<double>(in.count());
    return errors;
}

PairFinding measure_pair(gpu::Device& device, const Pair& pair, const PairLimits& limits) {
    const Inputs all = pair.inputs(limits.inputs, 1);
    Inputs judged{all.arity, {}};
    for (std::size_t i = 0; i < all.count(); ++i)
        if (pair.sure(all[i], pair.expected(all[i]))) judged.values.insert(judged.values.end(), all[i].begin(), all[i].end());
    PairFinding finding{pair, judged.count(), {}};
    const std::vector<Runnable> forms = runnables(device, pair, finding.forms);
    Bench bench = make_bench(device, judged);
    for (const Runnable& form : forms) {
        run_form(bench, form.pipeline, 1);
        finding.forms[form.form].errors = errors_of(pair, judged, results_of(bench, 1));
    }
    Inputs timed{all.arity, {}}; // the same tuples again and again, shuffled as they are
    for (std::size_t i = 0; i < limits.invocations; ++i) {
        const std::span<const float> tuple = judged[(i * 7919) % judged.count()];
        timed.values.insert(timed.values.end(), tuple.begin(), tuple.end());
    }
    Bench clock = make_bench(device, timed);
    time_forms(clock, pair, forms, finding.forms, limits);
    return finding;
}

} // namespace lightbench::kernels
