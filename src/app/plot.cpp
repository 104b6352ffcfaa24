// lightbench plot KIND [--param k=v] [-o FILE]: curves of the formulas that the renderers use, as CSV or SVG; --list names them.
#include "app/commands.h"
#include "app/errors.h"
#include "app/numbers.h"
#include "image/file_bytes.h"
#include "measure/plot_kinds.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <set>

namespace lightbench {
namespace {

struct PlotArguments {
    std::string kind;
    std::vector<std::string> parameters, outputs;
    bool list = false;
};

std::string range_of(const PlotParameter& p) {
    if (!p.words.empty()) return fmt::format("{}: one of {}", p.usual, fmt::join(p.words, ", "));
    const std::string many = p.most > 1 ? fmt::format(", up to {} with commas between", p.most) : "";
    return fmt::format("{}, {} from {:g} to {:g}{}{}", p.usual, p.whole ? "whole" : "any", p.min, p.max, many,
                       p.only.empty() ? "" : fmt::format("; with {}", p.only));
}

void list_kinds() {
    for (const PlotKind& kind : plot_kinds()) {
        fmt::print("{:<14}{}\n", kind.name, kind.description);
        for (const PlotParameter& p : kind.parameters) fmt::print("  {:<16}{} ({})\n", p.name, p.meaning, range_of(p));
    }
}

std::string extension_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return extension;
}

void plot(const PlotArguments& arguments) {
    if (arguments.list) return list_kinds();
    Problems problems;
    if (arguments.kind.empty()) problems.push_back({"plot", 0, 0, "KIND is missing; plot --list names them"});
    for (const std::string& output : arguments.outputs)
        if (const std::string extension = extension_of(output); extension != ".svg" && extension != ".csv")
            problems.push_back({"-o", 0, 0, fmt::format("\"{}\" must end in .svg or .csv", output)});
    std::set<std::filesystem::path> names;
    for (const std::string& output : arguments.outputs)
        if (!names.insert(std::filesystem::absolute(output).lexically_normal()).second)
            problems.push_back({"-o", 0, 0, fmt::format("\"{}\" is there twice; once is right", output)});
    const NamedTexts parameters = split_parameters(arguments.parameters, problems);
    std::variant<Plot, Problems> made = Problems{};
    if (!arguments.kind.empty()) made = make_plot(arguments.kind, parameters);
    if (const auto* found = std::get_if<Problems>(&made)) problems.insert(problems.end(), found->begin(), found->end());
    if (!problems.empty()) throw UserError(problems);
    const Plot& drawn = std::get<Plot>(made);
    if (arguments.outputs.empty()) fmt::print("{}", plot_csv(drawn));
    std::vector<std::string> texts; // all of them before any is written
    for (const std::string& output : arguments.outputs) texts.push_back(extension_of(output) == ".svg" ? plot_svg(drawn) : plot_csv(drawn));
    for (std::size_t i = 0; i < texts.size(); ++i) write_file(arguments.outputs[i], texts[i]);
}

} // namespace

void add_plot(CLI::App& app, int&) {
    auto arguments = std::make_shared<PlotArguments>();
    CLI::App* sub = app.add_subcommand("plot", "draws curves of the formulas: brdf, fresnel, attenuation, form-factor");
    sub->add_option("KIND", arguments->kind, "one of --list");
    sub->add_option("--param", arguments->parameters, "a parameter of the kind; several --param")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all();
    sub->add_option("-o,--output", arguments->outputs, "an .svg or .csv file; several -o; without one, CSV on standard output")
        ->type_name("FILE")
        ->expected(1)
        ->take_all();
    sub->add_flag("--list", arguments->list, "names the kinds and their parameters");
    sub->callback([arguments] { plot(*arguments); });
}

} // namespace lightbench
