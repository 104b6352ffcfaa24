// lightbench numerics: the error bounds of the shader functions, tried on this device; exit code 1 if one is violated. --pairs: stable against
// naive formulas instead, their errors and costs. --json: the keys are those of json_of().
#include "measure/numerics/findings.h"

#include "app/commands.h"
#include "app/errors.h"
#include "app/numerics_pairs.h"
#include "app/table.h"
#include "app/validation.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

using kernels::Finding;
using nlohmann::ordered_json;

struct NumericsArguments {
    std::string device, only;
    bool json = false, quick = false, pairs = false;
};

// Numbers that JSON lacks are null.
ordered_json number(double x) {
    return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr);
}

// what: the part of the results that the bound is of, empty for the result; bound in words, u = 2^-24; share: of the bound at the worst
// input, null if infinite or not judged; error: |got - expected| there; where: the arguments there, as text, since floats include NaN.
ordered_json json_of(const Finding& f) {
    ordered_json where = ordered_json::array();
    for (const float x : f.verdict.where) where.push_back(fmt::format("{:a}", x));
    return {{"function", f.function},
            {"file", f.file},
            {"what", f.what},
            {"domain", f.domain},
            {"bound", f.bound},
            {"inputs", f.inputs},
            {"outside", f.verdict.outside},
            {"holds", f.verdict.holds},
            {"share", f.verdict.judged ? number(f.verdict.share) : ordered_json(nullptr)},
            {"error", f.verdict.judged ? number(f.verdict.off) : ordered_json(nullptr)},
            {"where", where},
            {"message", f.verdict.message}};
}

constexpr std::size_t kMostShown = 4; // arguments of the worst input in the table; the message and --json have all

std::string where_of(const std::vector<float>& where) {
    std::string text;
    for (std::size_t i = 0; i < std::min(where.size(), kMostShown); ++i) text += fmt::format("{}{:.9g}", i ? " " : "", where[i]);
    return where.size() > kMostShown ? fmt::format("{} ... ({} numbers)", text, where.size()) : text;
}

std::vector<std::string> cells_of(const Finding& f) {
    const bool judged = f.verdict.judged;
    return {f.what.empty() ? f.function : fmt::format("{}: {}", f.function, f.what),
            f.domain,
            f.bound,
            judged ? fmt::format("{:.3f}", f.verdict.share) : "-",
            judged ? fmt::format("{:.3g}", f.verdict.off) : "-",
            where_of(f.verdict.where)};
}

void print_text(const std::vector<Finding>& findings, const gpu::DeviceInfo& device) {
    std::vector<std::vector<std::string>> table{{"function", "domain", "bound, u = 2^-24", "share", "error", "where"}};
    std::size_t violated = 0, inputs = 0;
    for (const Finding& f : findings) table.push_back(cells_of(f)), violated += !f.verdict.holds, inputs += f.inputs;
    fmt::print("{}, {}\n{}", device.name, device.version, aligned(table));
    for (const Finding& f : findings)
        if (!f.verdict.holds) fmt::print("violated: {}\n", f.verdict.message);
    fmt::print("{} of {} bounds hold, over {} results\n", findings.size() - violated, findings.size(), inputs);
}

void print_json(const std::vector<Finding>& findings, const gpu::DeviceInfo& device) {
    ordered_json rows = ordered_json::array();
    bool holds = true;
    for (const Finding& f : findings) rows.push_back(json_of(f)), holds = holds && f.verdict.holds;
    const ordered_json all{
        {"device", device.name}, {"driver", device.driver}, {"version", device.version}, {"holds", holds}, {"rows", rows}};
    fmt::print("{}\n", all.dump(2, ' ', false, ordered_json::error_handler_t::replace));
}

int run_bounds(const NumericsArguments& arguments) {
    const kernels::Rows rows = kernels::rows_about(arguments.only);
    if (rows.empty())
        throw UserError("--only", fmt::format("no function or file contains \"{}\"; right would be one like phong_specular or lib/ray",
                                              arguments.only));
    gpu::Device device = gpu::Device::open({arguments.device});
    const std::vector<Finding> findings = kernels::run_rows(device, rows, arguments.quick ? kernels::kQuickInputs : kernels::kUsualInputs);
    arguments.json ? print_json(findings, device.info()) : print_text(findings, device.info());
    close_and_check(std::move(device));
    return std::ranges::all_of(findings, [](const Finding& f) { return f.verdict.holds; }) ? 0 : 1;
}

int run_pairs(const NumericsArguments& arguments) {
    std::vector<kernels::Pair> pairs = kernels::all_pairs();
    std::erase_if(pairs, [&](const kernels::Pair& pair) { return pair.name.find(arguments.only) == std::string::npos; });
    if (pairs.empty())
        throw UserError("--only", fmt::format("no pair contains \"{}\"; right would be one like sphere or Fresnel", arguments.only));
    gpu::Device device = gpu::Device::open({arguments.device});
    print_pairs(device, pairs, arguments.quick, arguments.json);
    close_and_check(std::move(device));
    return 0;
}

} // namespace

void add_numerics(CLI::App& app, int& exit_code) {
    auto arguments = std::make_shared<NumericsArguments>();
    CLI::App* sub = app.add_subcommand("numerics", "the error bounds of the shader functions, tried on this device");
    sub->add_option("--device", arguments->device, "part of a device's name, or its index in lightbench devices")->type_name("D");
    sub->add_option("--only", arguments->only, "functions whose name or file contains the text; of --pairs, names")->type_name("TEXT");
    sub->add_flag("--pairs", arguments->pairs, "stable against naive formulas: their errors, and what each costs here");
    sub->add_flag("--quick", arguments->quick, "fewer inputs");
    sub->add_flag("--json", arguments->json, "as JSON");
    sub->callback([arguments, &exit_code] { exit_code = arguments->pairs ? run_pairs(*arguments) : run_bounds(*arguments); });
}

} // namespace lightbench
