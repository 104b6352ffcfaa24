// lightbench view [SCENE]: the viewer, from its options to its end.
#include "app/assets.h"
#include "app/commands.h"
#include "app/errors.h"
#include "app/interrupt.h"
#include "app/view/viewer.h"
#include "image/file_bytes.h"

#include <CLI/CLI.hpp>

namespace lightbench {
namespace {

struct ViewArguments {
    Given given;
    std::string screenshots, log;
    bool no_vsync = false, list_keys = false;
};

view::ViewOptions check_arguments(const ViewArguments& arguments) {
    Problems problems;
    view::ViewOptions options;
    options.scene = parse_scene_options(arguments.given, problems);
    if (options.scene.scene.empty()) options.scene.scene = find_assets() / "scenes/default.toml";
    if (options.scene.frames) problems.push_back({"--frames", 0, 0, "the viewer shows one frame; --frame N chooses where it starts"});
    if (options.scene.request.terms) problems.push_back({"--terms", 0, 0, "layers go into an .exr; `lightbench render` writes it"});
    if (!options.scene.solution.empty())
        problems.push_back({"--solution", 0, 0, "the viewer keeps its solutions while it runs; `lightbench render` keeps them in files"});
    if (!options.scene.stats.empty())
        problems.push_back({"--stats", 0, 0, "times are in the panel; `lightbench render` with the command copied there writes them"});
    for (const auto& [flag, reason] : {std::pair{"--progress", "what is being done stands over the picture"},
                                       {"--quiet", "the viewer says nothing but errors"},
                                       {"--count", "counts are for --stats, which `lightbench render` writes"}})
        if (arguments.given.contains(flag)) problems.push_back({flag, 0, 0, reason});
    options.log = arguments.log, options.vsync = !arguments.no_vsync;
    if (!arguments.screenshots.empty()) options.screenshots = arguments.screenshots;
    std::error_code ignored;
    if (!std::filesystem::is_directory(options.screenshots, ignored))
        problems.push_back({"--screenshots", 0, 0, fmt::format("there is no folder {}; it must exist", options.screenshots.string())});
    if (!problems.empty()) throw UserError(problems);
    return options;
}

// The exit code.
int run_viewer(const ViewArguments& arguments) {
    if (arguments.list_keys) return fmt::print("{}", view::keys_markdown()), 0;
    const view::ViewOptions options = check_arguments(arguments);
    const SceneOptions& scene = options.scene;
    view::Opened opened = view::open_scene(scene.scene, load_or_throw(scene.scene, scene.allow_outside), scene.request, 1);
    const Interrupt interrupt({SIGINT, SIGTERM, SIGHUP});
    view::Viewer viewer(options, std::move(opened), view::open_beside_window({scene.device}));
    viewer.run();
    viewer.close();
    return Interrupt::came() ? 128 + Interrupt::signal() : 0;
}

} // namespace

void add_view(CLI::App& app, int& code) {
    auto arguments = std::make_shared<ViewArguments>();
    CLI::App* sub = app.add_subcommand("view", "the interactive viewer: fly around a scene, switch what it shows and costs");
    declare_scene_options(*sub, arguments->given, false);
    sub->add_option("--screenshots", arguments->screenshots, "folder that F12 saves to; default the current one")->type_name("DIR");
    sub->add_option("--log", arguments->log, "what happens, a line each, into this file")->type_name("FILE");
    sub->add_flag("--no-vsync", arguments->no_vsync, "frames of the window do not wait for the screen");
    sub->add_flag("--list-keys", arguments->list_keys, "print the keys as a Markdown table, and end");
    sub->callback([arguments, &code] { code = run_viewer(*arguments); });
}

} // namespace lightbench
