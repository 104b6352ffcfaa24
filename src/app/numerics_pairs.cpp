// Runs the pairs and prints what was found: errors of each form, its cost, and how many times that of the stable form it is.
#include "app/numerics_pairs.h"

#include "app/table.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

using kernels::Form, kernels::PairFinding;
using nlohmann::ordered_json;

// Times the stable form's cost; 0 where one of the two is lost in the noise of the empty loop.
double ratio(const PairFinding& finding, const Form& form) {
    const double stable = finding.forms.front().cost.median;
    return stable > 0 && form.cost.median > 0 ? form.cost.median / stable : 0; // false for NaN
}

// lacking: why the form was not run, the keys after it are absent then; wrong: share of inputs; nanoseconds: a call, median and quartiles;
// ratio: of the median to the stable form's; null where they are lost in noise.
ordered_json json_of(const PairFinding& finding, const Form& form) {
    if (!form.lacking.empty()) return {{"form", form.name}, {"lacking", form.lacking}};
    const double times = ratio(finding, form);
    return {{"form", form.name},
            {"relative", form.errors.relative},
            {"ulp", form.errors.ulp},
            {"wrong", form.errors.wrong},
            {"nanoseconds", {{"median", form.cost.median}, {"q1", form.cost.q1}, {"q3", form.cost.q3}}},
            {"runs", form.cost.runs},
            {"settled", form.cost.settled},
            {"ratio", times > 0 ? ordered_json(times) : ordered_json(nullptr)}};
}

ordered_json json_of(const PairFinding& finding) {
    ordered_json forms = ordered_json::array();
    for (const Form& form : finding.forms) forms.push_back(json_of(finding, form));
    return {{"pair", finding.pair.name},     {"stable", finding.pair.stable}, {"naive", finding.pair.naive},
            {"domain", finding.pair.domain}, {"inputs", finding.inputs},      {"forms", forms}};
}

std::vector<std::string> cells_of(const PairFinding& finding, const Form& form) {
    const std::string name = fmt::format("{}: {}", finding.pair.name, form.name);
    if (!form.lacking.empty()) return {name, "-", "-", "-", "-", "-", "-", form.lacking};
    const double times = ratio(finding, form);
    const bool lost = std::isnan(form.cost.median);
    return {name,
            fmt::format("{:.2g}", form.errors.relative),
            finding.pair.distance ? "-" : fmt::format("{:.3g}", form.errors.ulp),
            fmt::format("{:.2f} %", 100 * form.errors.wrong),
            lost ? "lost" : fmt::format("{:.3g}", form.cost.median),
            lost ? "-" : fmt::format("{:.3g} to {:.3g}", form.cost.q1, form.cost.q3),
            times > 0 ? fmt::format("{:.2f}", times) : "-",
            &form == &finding.forms.front() ? finding.pair.stable : finding.pair.naive};
}

void print_text(const std::vector<PairFinding>& findings, const gpu::DeviceInfo& device) {
    std::vector<std::vector<std::string>> table{{"pair", "relative", "ulp", "wrong", "ns a call", "quartiles", "cost", "formula"}};
    for (const PairFinding& finding : findings)
        for (const Form& form : finding.forms) table.push_back(cells_of(finding, form));
    fmt::print("{}, {}\n{}", device.name, device.version, aligned(table));
    for (const PairFinding& finding : findings) fmt::print("{}: {} inputs, {}\n", finding.pair.name, finding.inputs, finding.pair.domain);
    fmt::print("relative, ulp: the worst of results that are numbers as expected; of decisions, how far the worst wrong one is from its "
               "threshold\nwrong: not finite, a hit or a miss or a decision that is wrong; cost: times that of the stable formula; lost: "
               "as fast as an empty "
               "loop, to its noise\n");
}

} // namespace

void print_pairs(gpu::Device& device, const std::vector<kernels::Pair>& pairs, bool quick, bool json) {
    const kernels::PairLimits usual,
        limits = quick ? kernels::PairLimits{1u << 12, 1u << 12, 0.2, {.most = kFirstLook, .milliseconds = 500}} : usual;
    std::vector<PairFinding> findings;
    for (const kernels::Pair& pair : pairs) findings.push_back(kernels::measure_pair(device, pair, limits));
    if (!json) return print_text(findings, device.info());
    ordered_json all = ordered_json::array();
    for (const PairFinding& finding : findings) all.push_back(json_of(finding));
    const ordered_json whole{
        {"device", device.info().name}, {"driver", device.info().driver}, {"version", device.info().version}, {"pairs", all}};
    fmt::print("{}\n", whole.dump(2, ' ', false, ordered_json::error_handler_t::replace));
}

} // namespace lightbench
