// lightbench plan SCENE: what would run and why, what would not and why not. Needs no device.
#include "app/commands.h"
#include "app/errors.h"
#include "app/options.h"
#include "app/prepare.h"
#include "plan/explain.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace lightbench {
namespace {

struct PlanArguments {
    Given given;
    bool json = false;
};

void plan(const PlanArguments& arguments) {
    Problems problems;
    SceneOptions options = parse_scene_options(arguments.given, problems);
    if (options.frames) problems.push_back({"--frames", 0, 0, "a plan is made for one frame; --frame N chooses it"});
    if (!options.stats.empty()) problems.push_back({"--stats", 0, 0, "there is no run to tell of; --json prints the plan"});
    if (!problems.empty()) throw UserError(problems);
    if (options.request.terms) options.request.output = Output::radiance; // layers exist in .exr files only
    Scene scene = load_or_throw(options.scene, options.allow_outside);
    const Prepared prepared = prepare(scene, options.request);
    fmt::print("{}", arguments.json ? explain_json(prepared.plan) : explain(prepared.plan));
}

} // namespace

void add_plan(CLI::App& app, int&) {
    auto arguments = std::make_shared<PlanArguments>();
    CLI::App* sub = app.add_subcommand("plan", "what will run and why, and what will not and why not");
    declare_scene_options(*sub, arguments->given);
    sub->add_flag("--json", arguments->json, "as JSON");
    sub->callback([arguments] { plan(*arguments); });
}

} // namespace lightbench
