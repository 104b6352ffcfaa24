// lightbench make KIND [--param k=v] -o FILE: procedural scenes; --list names the kinds and their parameters.
#include "scene/make.h"
#include "app/commands.h"
#include "app/errors.h"
#include "app/numbers.h"
#include "scene/write.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace lightbench {
namespace {

struct KindArguments {
    std::string kind, output;
    std::vector<std::string> parameters;
    bool list = false;
};

std::string range_of(const MakeParameter& p) {
    return fmt::format("{:g}, {} from {:g} to {:g}", p.default_value, p.integer ? "whole" : "any", p.min, p.max);
}

void list_kinds() {
    for (const MakeKind& kind : make_kinds()) {
        fmt::print("{:<14}{}\n", kind.name, kind.description);
        for (const MakeParameter& p : kind.parameters) fmt::print("  {:<16}{} ({})\n", p.name, p.meaning, range_of(p));
    }
}

void make(const KindArguments& arguments) {
    if (arguments.list) return list_kinds();
    Problems problems;
    if (arguments.kind.empty()) problems.push_back({"make", 0, 0, "KIND is missing; make --list names them"});
    if (arguments.output.empty()) problems.push_back({"make", 0, 0, "-o FILE is missing"});
    const MakeArguments parameters = split_parameters(arguments.parameters, problems);
    if (!problems.empty()) throw UserError(problems);
    auto made = make_scene(arguments.kind, parameters);
    if (auto* found = std::get_if<Problems>(&made)) throw UserError(*found);
    Problems unwritable = write_scene(std::get<Scene>(made), arguments.output);
    if (!unwritable.empty()) throw UserError(unwritable);
}

} // namespace

void add_make(CLI::App& app, int&) {
    auto arguments = std::make_shared<KindArguments>();
    CLI::App* sub = app.add_subcommand("make", "writes a procedural scene");
    sub->add_option("KIND", arguments->kind, "one of --list");
    sub->add_option("--param", arguments->parameters, "a parameter of the kind; several --param")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all();
    sub->add_option("-o,--output", arguments->output, "scene file; its extension is its format")->type_name("FILE");
    sub->add_flag("--list", arguments->list, "names the kinds and their parameters");
    sub->callback([arguments] { make(*arguments); });
}

} // namespace lightbench
