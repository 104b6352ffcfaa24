// lightbench cost SCENE --knob NAME[=v1,v2,...] -o DIR: what accuracy costs in time. Every value of a knob is rendered, held against a reference and
// timed; DIR gets cost.csv, cost.json, the plots, report.html and the pictures.
#include "app/commands.h"
#include "app/cost_folder.h"
#include "app/cost_knob.h"
#include "app/cost_table.h"
#include "app/errors.h"
#include "app/interrupt.h"
#include "app/live_shaders.h"
#include "app/numbers.h"
#include "app/prepare.h"
#include "app/stats.h"
#include "app/validation.h"
#include "measure/function_curves.h"
#include "measure/gnuplot.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>
#include <memory>

namespace lightbench {
namespace {

struct CostArguments {
    Given given;
    std::vector<std::string> knobs;
    std::string folder, rounds, seconds;
    bool list = false, strict = false;
};

// A sweep renders hundreds of pictures: as many pixels as 320 x 180, in the shape of the scene's own picture.
std::string default_size(const Scene& scene) {
    const glm::dvec2 size(scene.film.value_or(glm::uvec2(1280, 720)));
    const double scale = std::min(1.0, std::sqrt(320.0 * 180.0 / (size.x * size.y)));
    return fmt::format("{}x{}", std::max(1L, std::lround(size.x * scale)), std::max(1L, std::lround(size.y * scale)));
}

RoundLimits parse_limits(const CostArguments& a, Problems& problems) {
    RoundLimits limits;
    if (!a.rounds.empty()) {
        limits.most = parse_unsigned<10000>(a.rounds).value_or(0);
        if (limits.most == 0)
            problems.push_back({"--rounds", 0, 0, fmt::format("\"{}\" must be a whole number from 1 to 10000", a.rounds)});
    }
    if (!a.seconds.empty()) {
        const auto seconds = parse_number<0, 100000>(a.seconds);
        if (!seconds) problems.push_back({"--seconds", 0, 0, fmt::format("\"{}\" must be a number from 0 to 100000", a.seconds)});
        limits.milliseconds = 1000 * seconds.value_or(0);
    }
    return limits;
}

std::vector<KnobUse> parse_knobs(const std::vector<std::string>& texts, Problems& problems) {
    std::vector<KnobUse> uses;
    for (const std::string& text : texts) {
        if (text == kFunctionsKnob) continue;
        std::string problem;
        const auto use = parse_knob(text, problem);
        if (!use)
            problems.push_back({"--knob", 0, 0, problem});
        else if (std::ranges::find(uses, use->knob, &KnobUse::knob) != uses.end())
            problems.push_back({"--knob", 0, 0, fmt::format("{} is there twice; list all values after one", use->knob->name)});
        else
            uses.push_back(*use);
    }
    if (std::ranges::count(texts, kFunctionsKnob) > 1)
        problems.push_back({"--knob", 0, 0, fmt::format("{} is there twice; once is enough", kFunctionsKnob)});
    return uses;
}

// Options of render that a report has no place for, or that would change what is timed.
void check_options(const CostArguments& a, Problems& problems) {
    for (const char* flag : {"--frames", "--terms", "--stats", "--count", "--solution", "--show", "--pick"})
        if (a.given.contains(flag)) problems.push_back({flag, 0, 0, "belongs to render; cost measures whole pictures of one frame"});
    if (!a.given.contains("SCENE")) problems.push_back({"cost", 0, 0, "SCENE is missing"});
    if (a.knobs.empty()) problems.push_back({"--knob", 0, 0, "is missing; lightbench cost --list names the knobs"});
    check_folder(a.folder, problems);
}

std::string report_command(const CostArguments& a) {
    OptionTexts options = a.given;
    for (const char* flag : {"--quiet", "--progress"}) options.erase(flag);
    std::string command = "lightbench cost " + command_of(options, a.folder);
    for (const std::string& knob : a.knobs) command += fmt::format(" --knob {}", knob);
    if (!a.rounds.empty()) command += fmt::format(" --rounds {}", a.rounds);
    if (!a.seconds.empty()) command += fmt::format(" --seconds {}", a.seconds);
    return command;
}

CostReport start_report(const CostArguments& a, const SceneOptions& options, const gpu::DeviceInfo& device) {
    CostReport report;
    report.program = fmt::format("lightbench {}", LIGHTBENCH_VERSION);
    report.scene = options.scene.string();
    const glm::uvec2 size = options.request.crop ? options.request.crop->size : options.request.size.value();
    report.width = size.x, report.height = size.y;
    report.device = device.name, report.driver = device.driver, report.version = device.version;
    report.command = report_command(a);
    return report;
}

// With the method that the first knob which belongs to one brings along, if none was typed: --patch is no problem beside --knob shots.
OptionTexts with_method(OptionTexts texts, const std::vector<KnobUse>& uses) {
    for (const KnobUse& use : uses)
        if (!use.knob->method.empty()) texts.try_emplace("--method", use.knob->method);
    return texts;
}

struct PlannedReport {
    SceneOptions options; // with the size
    RoundLimits limits;
    std::vector<PlannedKnob> knobs;
};

bool wants_functions(const CostArguments& a) {
    return std::ranges::find(a.knobs, kFunctionsKnob) != a.knobs.end();
}

// All curves as far as they are known.
CostReport outline_of(const std::vector<PlannedKnob>& knobs, const CostArguments& a) {
    CostReport outline;
    for (const PlannedKnob& knob : knobs) outline.curves.push_back(planned_curve(knob));
    if (wants_functions(a))
        for (const kernels::Pair& pair : kernels::all_pairs()) outline.curves.push_back(curve_of({pair, 0, {}}));
    return outline;
}

// Everything that can be wrong with the command line and the scene, before a device is opened.
PlannedReport plan_report(const CostArguments& a, Scene& scene) {
    Problems problems;
    check_options(a, problems);
    PlannedReport planned{{}, parse_limits(a, problems), {}};
    const std::vector<KnobUse> uses = parse_knobs(a.knobs, problems);
    parse_scene_options(with_method(a.given, uses), problems);
    if (!problems.empty()) throw UserError(problems);
    scene = load_or_throw(a.given.find("SCENE")->second, a.given.contains("--allow-outside"));
    OptionTexts texts = a.given;
    texts.try_emplace("--size", default_size(scene));
    planned.options = parse_scene_options(with_method(texts, uses), problems);
    for (const KnobUse& use : uses) planned.knobs.push_back(plan_knob(use, scene, texts, problems));
    check_outputs(a.folder, outline_of(planned.knobs, a), problems);
    if (!problems.empty()) throw UserError(problems);
    return planned;
}

// Results as soon as there are some: a sweep takes minutes, and what reads them may be a pipe.
void print_curve(const CostCurve& curve) {
    fmt::print("{}", curve_table(curve));
    std::fflush(stdout);
}

// Those that were typed, shared among the pairs.
kernels::PairLimits pair_limits(const CostArguments& a, const RoundLimits& typed) {
    kernels::PairLimits limits;
    if (!a.rounds.empty()) limits.rounds.most = typed.most;
    if (!a.seconds.empty()) limits.rounds.milliseconds = typed.milliseconds / double(kernels::all_pairs().size());
    return limits;
}

// Stable against naive formulas, which no picture shows.
void add_functions(CostReport& report, gpu::Device& device, const kernels::PairLimits& limits, const Messages& messages) {
    messages.step("trying shader functions");
    for (CostCurve& curve : function_curves(device, limits, Interrupt::came)) {
        print_curve(curve);
        report.curves.push_back(std::move(curve));
    }
}

// What a user would rather know before than after.
bool draws_plots(const Messages& messages) {
    const bool can = has_gnuplot();
    if (!can)
        messages.say(
            "warning: no plots: gnuplot, which draws the SVG files, cannot be run (Debian's package is gnuplot-nox); the rest of the "
            "report comes, with charts in report.html");
    return can;
}

// Knob by knob, the report written after each: what goes wrong later costs nothing that was measured. Returns how many expectations are broken.
std::size_t measure(const PlannedReport& planned, const CostArguments& a, gpu::Device& device, const Scene& scene, CostReport& report,
                    const Messages& messages) {
    ReportFolder folder{a.folder, draws_plots(messages)};
    const auto write = [&] {
        if (const std::string why = write_report(report, folder); !why.empty()) messages.say(fmt::format("warning: no plots: {}", why));
    };
    std::size_t broken = 0;
    for (const PlannedKnob& knob : planned.knobs) {
        const Stopwatch watch;
        const Swept swept = measure_knob(knob, {device, scene, folder, planned.limits, messages});
        if (swept.stopped) break;
        report.curves.push_back(swept.curve), broken += swept.broken;
        print_curve(swept.curve);
        write();
        messages.say(fmt::format("{}: {:.1f} s", knob.knob->name, watch.milliseconds() / 1000));
    }
    if (wants_functions(a) && !Interrupt::came()) {
        add_functions(report, device, pair_limits(a, planned.limits), messages);
        write();
    }
    return broken;
}

void warn_of_overridden(const std::vector<PlannedKnob>& knobs, const Messages& messages) {
    for (const PlannedKnob& knob : knobs)
        if (!knob.overridden.empty())
            messages.say(fmt::format("warning: --knob {}: it turns {}; what was typed there has no effect on all of its points",
                                     knob.knob->name, fmt::join(knob.overridden, ", ")));
}

// Returns the exit code.
int cost(const CostArguments& a) {
    if (a.list) {
        fmt::print("{}{:<14}stable formulas of shader functions against the textbooks', and those in float64\n"
                   "  reference   an oracle of 60 digits; milliseconds are those of 10^6 calls\n",
                   knob_list(), kFunctionsKnob);
        return 0;
    }
    Scene scene;
    const PlannedReport planned = plan_report(a, scene);
    const Messages messages{planned.options.quiet, planned.options.progress};
    warn_of_overridden(planned.knobs, messages);
    try_folder(a.folder);
    const Interrupt interrupt;
    messages.step("opening the device");
    gpu::Device device = gpu::Device::open({planned.options.device});
    use_shaders(device, planned.options.shaders, planned.options.sliders);
    CostReport report = start_report(a, planned.options, device.info());
    const std::size_t broken = measure(planned, a, device, scene, report, messages);
    close_and_check(std::move(device));
    if (Interrupt::came()) {
        messages.say(report.curves.empty() ? "interrupted: nothing was measured yet"
                                           : fmt::format("interrupted: {} holds what was measured: {} curve{}", a.folder,
                                                         report.curves.size(), report.curves.size() == 1 ? "" : "s"));
        return kInterrupted;
    }
    return a.strict && broken > 0 ? 1 : 0;
}

} // namespace

void add_cost(CLI::App& app, int& exit_code) {
    auto a = std::make_shared<CostArguments>();
    CLI::App* sub = app.add_subcommand("cost", "accuracy against time: every value of a knob rendered, compared and timed");
    declare_scene_options(*sub, a->given);
    sub->get_option("SCENE")->required(false);
    sub->add_option("--knob", a->knobs, "what to turn, one of --list, and its values; several --knob")
        ->type_name("NAME[=v1,v2,...]")
        ->expected(1)
        ->take_all();
    sub->add_option("-o,--output", a->folder, "folder of the report; made if it is not there")->type_name("DIR");
    sub->add_option("--rounds", a->rounds, "runs of each value at most; default 100")->type_name("N");
    sub->add_option("--seconds", a->seconds, "of repeating the runs of a knob at most; default 240")->type_name("S");
    sub->add_flag("--list", a->list, "names the knobs, what they mean and what they are held against");
    sub->add_flag("--strict", a->strict, "exit code 1 if an error rises where theory lets it fall, or a picture differs where it may not");
    sub->callback([a, &exit_code] { exit_code = cost(*a); });
}

} // namespace lightbench
