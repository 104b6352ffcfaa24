// lightbench render SCENE -o FILE: one image, or the frames of a turntable, each decided, tessellated and rendered on its own, so that
// frame N is the same bytes alone and in a sequence.
#include "app/budget.h"
#include "app/commands.h"
#include "app/errors.h"
#include "app/interrupt.h"
#include "app/live_shaders.h"
#include "app/messages.h"
#include "app/options.h"
#include "app/pictures.h"
#include "app/prepare.h"
#include "app/stats.h"
#include "app/validation.h"
#include "image/file_bytes.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <iostream>
#include <memory>

namespace lightbench {
namespace {

struct RenderArguments {
    Given given;
    std::string output, spirv;
    BudgetArguments budget;
};

// Options that only choose among measurements.
void check_budget(const BudgetArguments& b, Problems& problems) {
    if (b.wanted()) return;
    for (const auto& [flag, text] : {std::pair{"--metric", b.metric}, {"--cost", b.cost}, {"--knob", b.knob}})
        if (!text.empty()) problems.push_back({flag, 0, 0, "belongs to --budget or --max-error"});
}

// All problems of the command line together.
SceneOptions check_arguments(const RenderArguments& arguments, const Given& given) {
    Problems problems;
    SceneOptions options = parse_scene_options(given, problems);
    check_budget(arguments.budget, problems);
    const bool several = options.frames.has_value();
    check_output(arguments.output, several, problems);
    options.request.output = output_of(arguments.output).value_or(Output::pixels);
    if (options.request.terms && options.request.output != Output::radiance)
        problems.push_back({"--terms", 0, 0, fmt::format("layers need an .exr; -o names {}", arguments.output)});
    if (!arguments.spirv.empty() && !(options.shaders.empty() && options.sliders.empty()))
        problems.push_back({"--spirv", 0, 0, "either compiled entry points or --shader and --slider, which are compiled"});
    if (several && !options.stats.empty() && options.stats != "-" && frame_path(options.stats, 0) == options.stats)
        problems.push_back({"--stats", 0, 0, fmt::format("\"{}\" must hold %04d, or be -, if there are several frames", options.stats)});
    if (!problems.empty()) throw UserError(problems);
    return options;
}

void write_output(const std::string& path, const RenderOutput& output) {
    if (output.pixels) return write_pixels(path, *output.pixels);
    std::vector<NamedImage> layers;
    for (const Layer& layer : output.layers) layers.push_back({layer.name, &layer.image});
    write_radiance(path, output.radiance.value(), layers);
}

void write_stats(const std::string& path, const std::string& json) {
    if (path.empty()) return;
    if (path == "-")
        fmt::print("{}", json);
    else
        write_file(path, json);
}

struct Run {
    const SceneOptions& options;
    const std::string& output;
    const std::string& spirv;
    Messages messages;
    Stopwatch wall;
    double load_ms = 0;
    bool interrupted = false;
    std::optional<BudgetChoice> choice{}; // of --budget
    std::optional<gpu::Device> device{};  // opened when the first frame is ready: a wrong camera is no reason to wait for a driver
};

// Of --spirv: "-" stands for a line of standard input, which comes once the entry points are there. Until then everything else is made ready.
std::string modules_folder(const std::string& named) {
    if (named != "-") return named;
    std::string line;
    if (!std::getline(std::cin, line)) throw UserError("--spirv", "no folder came on standard input");
    return line;
}

gpu::Device& device_of(Run& run) {
    if (run.device) return *run.device;
    run.messages.step("opening the device");
    run.device.emplace(gpu::Device::open({run.options.device}));
    if (!run.spirv.empty())
        use_modules(*run.device, modules_folder(run.spirv));
    else
        use_shaders(*run.device, run.options.shaders, run.options.sliders);
    run.messages.step("rendering on " + run.device->info().name);
    if (run.choice)
        if (const std::string warning = warning_of_device(*run.choice, run.device->info()); !warning.empty())
            run.messages.say("warning: --budget: " + warning);
    return *run.device;
}

void report(const Run& run, const std::string& path, const RenderOutput& output, const Plan& plan) {
    if (output.non_finite > 0) run.messages.say(fmt::format("warning: {} pixels of {} are not finite", output.non_finite, path));
    run.messages.say(
        fmt::format("{}: {}x{}, {:.1f} ms on the device", path, plan.crop.size.x, plan.crop.size.y, output.device_milliseconds));
}

// Rays and radiosity take their time: what they have come to is shown, and Ctrl-C keeps it.
RenderOutput trace_watched(Run& run, Renderer& renderer, const View& view, const std::string& path) {
    const Interrupt interrupt;
    int shown = -1;
    RenderOptions options;
    options.solution = run.options.solution;
    options.stop = [] { return Interrupt::came(); };
    options.progress = [&](double share) { run.messages.bar(share, shown); };
    if (run.messages.shows_progress()) options.pass = [&](const RenderOutput& so_far) { write_output(path, so_far); };
    RenderOutput output = renderer.render(view, options);
    run.messages.clear_bar(shown);
    run.interrupted = output.done < 1 || output.stopped;
    write_output(path, output);
    if (output.stopped) {
        run.messages.say(fmt::format("interrupted: {} shows the light after {} shots, {:.2g} of it unshot", path, output.radiosity->shots,
                                     output.radiosity->unshot));
    } else if (run.interrupted)
        run.messages.say(fmt::format("interrupted: {} holds {:.0f} % of the picture", path, 100 * output.done));
    return output;
}

RenderOutput render_and_write(Run& run, Renderer& renderer, const Prepared& prepared, const std::string& path) {
    if (prepared.plan.method != Method::raster) return trace_watched(run, renderer, prepared.view, path);
    RenderOutput output = renderer.render(prepared.view);
    write_output(path, output);
    return output;
}

// One image: `frame` of the turntable, or the scene as it is.
void render_frame(Run& run, Scene& scene, std::optional<int> frame, bool first) {
    Request request = run.options.request;
    if (frame) request.frame = frame;
    const Prepared prepared = prepare(scene, request);
    if (first) run.messages.fallbacks(prepared.plan);
    gpu::Device& device = device_of(run);
    const double pipelines_before = device.pipeline_milliseconds();
    Renderer renderer(device, scene, prepared.geometry, prepared.plan);
    const std::string path = frame ? frame_path(run.output, *frame) : run.output;
    const RenderOutput output = render_and_write(run, renderer, prepared, path);
    const RunRecord record{run.options.scene.string(), request.frame,
                           run.options.count,          run.load_ms,
                           run.wall.milliseconds(),    device.pipeline_milliseconds() - pipelines_before,
                           device.memory_peak(),       device.used_shaders()};
    write_stats(frame ? frame_path(run.options.stats, *frame) : run.options.stats,
                stats_json(record, prepared.plan, device.info(), output));
    if (!run.interrupted) report(run, path, output, prepared.plan);
}

// Completing a scene adds a camera and a headlight to it, which belong to one frame: each starts from the scene as it was read.
void render_frames(Run& run, Scene& scene) {
    const auto cameras = scene.cameras;
    const auto lights = scene.lights;
    const FrameRange range = *run.options.frames;
    const int count = range.last - range.first + 1;
    for (int i = 0; i < count && !run.interrupted; ++i) {
        run.messages.step(fmt::format("frame {} of {} to {}", range.first + i, range.first, range.last));
        scene.cameras = cameras, scene.lights = lights;
        render_frame(run, scene, range.first + i, i == 0);
    }
}

// Read when it is first asked for.
struct LoadedScene {
    std::optional<Scene> scene;
    double milliseconds = 0;
};

Scene& load(LoadedScene& loaded, const Given& given) {
    if (loaded.scene) return *loaded.scene;
    const Stopwatch watch;
    loaded.scene = load_or_throw(given.find("SCENE")->second, given.contains("--allow-outside"));
    loaded.milliseconds = watch.milliseconds();
    return *loaded.scene;
}

glm::uvec2 film_of(const Scene& scene) {
    return scene.film.value_or(Plan{}.size);
}

void tell(const Messages& messages, const BudgetChoice& choice) {
    messages.say(choice.sentence);
    if (!choice.measured_for.empty()) messages.say("warning: --budget: " + choice.measured_for);
}

// Returns the exit code.
int render(const RenderArguments& arguments) {
    Given given = arguments.given;
    std::optional<BudgetChoice> choice;
    LoadedScene loaded;
    if (arguments.budget.wanted()) choice = apply_budget(arguments.budget, given, [&] { return film_of(load(loaded, given)); });
    const SceneOptions options = check_arguments(arguments, given);
    Run run{options, arguments.output, arguments.spirv, {options.quiet, options.progress}, {}, 0, false, choice};
    if (choice) tell(run.messages, *choice);
    run.messages.step("reading " + options.scene.string());
    Scene& scene = load(loaded, given);
    run.load_ms = loaded.milliseconds;
    options.frames ? render_frames(run, scene) : render_frame(run, scene, std::nullopt, true);
    close_and_check(std::move(*run.device));
    return run.interrupted ? kInterrupted : 0;
}

} // namespace

void add_render(CLI::App& app, int& exit_code) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* sub = app.add_subcommand("render", "one image of a scene: .png (display-referred) or .exr (linear radiance)");
    declare_scene_options(*sub, arguments->given);
    sub->add_option("-o,--output", arguments->output, "the picture: .png or .exr; with --frames its name holds %04d")
        ->required()
        ->type_name("FILE");
    sub->add_option(
           "--spirv", arguments->spirv,
           "compiled entry points in place of the program's own: DIR/raster/surface.frag.spv ...; -: DIR is read from standard input")
        ->type_name("DIR");
    sub->add_option_function<std::string>(
           "--budget", [arguments](const std::string& text) { arguments->budget.budget = text; },
           "the most accurate setting that takes no longer on the device, by --cost")
        ->type_name("TIME");
    sub->add_option_function<std::string>(
           "--max-error", [arguments](const std::string& text) { arguments->budget.max_error = text; },
           "the cheapest setting that errs no more, by --cost")
        ->type_name("X");
    sub->add_option("--metric", arguments->budget.metric, "of that error; default the knob's own")->type_name("NAME");
    sub->add_option("--cost", arguments->budget.cost, "the cost.json of lightbench cost")->type_name("FILE");
    sub->add_option("--knob", arguments->budget.knob, "of several in --cost the one to turn")->type_name("NAME");
    sub->callback([arguments, &exit_code] { exit_code = render(*arguments); });
}

} // namespace lightbench
