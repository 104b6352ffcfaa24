#include "app/budget.h"

#include "app/errors.h"
#include "app/numbers.h"
#include "image/file_bytes.h"
#include "measure/budget.h"
#include "measure/knobs.h"
#include "measure/report_json.h"
#include "scene/nearest.h"

#include <fmt/format.h>
#include <set>
#include <utility>

namespace lightbench {
namespace {

// "50", "50ms", "0.05s": milliseconds above 0.
std::optional<double> parse_milliseconds(std::string_view text) {
    double unit = 1;
    if (text.ends_with("ms"))
        text.remove_suffix(2);
    else if (text.ends_with("s"))
        text.remove_suffix(1), unit = 1000;
    const auto value = parse_whole<double>(text);
    return value && std::isfinite(*value) && *value > 0 ? std::optional(*value * unit) : std::nullopt;
}

Wish parse_wish(const BudgetArguments& a) {
    Problems problems;
    Wish wish;
    if (a.budget && !(wish.milliseconds = parse_milliseconds(*a.budget)))
        problems.push_back({"--budget", 0, 0, fmt::format("\"{}\" must be a time, like 50ms or 0.5s", *a.budget)});
    if (a.max_error) {
        wish.error = parse_whole<double>(*a.max_error);
        if (!wish.error || !(*wish.error >= 0) || !std::isfinite(*wish.error))
            problems.push_back({"--max-error", 0, 0, fmt::format("\"{}\" must be an error of at least 0", *a.max_error)});
    }
    if (a.cost.empty())
        problems.push_back({"--cost", 0, 0, "is missing: the cost.json of lightbench cost, whose measurements are to choose"});
    if (!problems.empty()) throw UserError(problems);
    return wish;
}

CostReport read_report(const std::string& path) {
    const std::vector<unsigned char> bytes = read_file(path);
    try {
        return read_cost_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } catch (const ReportError& error) {
        throw UserError(path, error.what());
    }
}

// Of pictures that differ. One: errors of two knobs are against two references, and are not compared.
const CostCurve& choose_curve(const CostReport& report, const BudgetArguments& a) {
    std::vector<const CostCurve*> curves;
    std::vector<std::string_view> names;
    for (const CostCurve& curve : report.curves)
        if (!curve.time_only && find_knob(curve.knob)) curves.push_back(&curve), names.push_back(curve.knob);
    if (curves.empty()) throw UserError(a.cost, "holds no knob that changes pictures; lightbench cost --list names those there are");
    if (a.knob.empty() && curves.size() > 1)
        throw UserError("--knob", fmt::format("is missing: {} holds {}, each with errors of its own kind", a.cost, fmt::join(names, ", ")));
    if (a.knob.empty()) return *curves.front();
    const auto it = std::ranges::find(curves, a.knob, &CostCurve::knob);
    if (it != curves.end()) return **it;
    const auto near = nearest_name(a.knob, names);
    throw UserError("--knob", near ? fmt::format("{} holds no knob \"{}\"; did you mean \"{}\"?", a.cost, a.knob, *near)
                                   : fmt::format("{} holds no knob \"{}\"; it must be one of {}", a.cost, a.knob, fmt::join(names, ", ")));
}

std::string text_of(const Wish& wish) {
    std::string text = wish.milliseconds ? fmt::format("{:g} ms", *wish.milliseconds) : "";
    if (wish.error) text += fmt::format("{}{} {:g}", text.empty() ? "" : " and ", wish.metric, *wish.error);
    return text;
}

std::string text_of(const CostCurve& curve, const CostPoint& point, const Wish& wish) {
    const std::string noise =
        point.runs == 1 ? "one run" : fmt::format("{:.4g} to {:.4g}", point.q1_ms * wish.time_scale, point.q3_ms * wish.time_scale);
    return fmt::format("{}={}, {:.4g} ms ({}), {} {:.4g}", curve.knob, point.value, point.device_ms * wish.time_scale, noise, wish.metric,
                       point.errors.find(wish.metric)->second);
}

// Nothing where --size or --crop is not understood: that is said with all other problems.
std::optional<glm::uvec2> size_of(const Given& given, const std::function<glm::uvec2()>& film) {
    if (const auto crop = given.find("--crop"); crop != given.end()) {
        const auto rect = parse_rect(crop->second);
        return rect ? std::optional(rect->size) : std::nullopt;
    }
    if (const auto size = given.find("--size"); size != given.end()) return parse_size(size->second);
    return film();
}

// A pixel costs what it costs, whatever the size; radiosity's time is spent on patches.
double time_scale_of(const CostReport& report, const Knob& knob, const Given& given, const std::function<glm::uvec2()>& film) {
    const auto method = given.find("--method");
    if (knob.method == "radiosity" || (method != given.end() && method->second == "radiosity")) return 1;
    const auto size = size_of(given, film);
    return size ? double(size->x) * size->y / (double(report.width) * report.height) : 1;
}

// Options that say nothing of what a pixel costs, or are compared by themselves.
bool is_neutral(std::string_view flag) {
    static const std::set<std::string_view> neutral = {"SCENE",   "--size",     "--seed",          "--stats",
                                                       "--quiet", "--progress", "--allow-outside", "--device"};
    return neutral.contains(flag);
}

// How a picture is made, as against what it shows and which files it reads: these a report may set.
bool is_setting(std::string_view flag) {
    static const std::set<std::string_view> settings = {
        "--method",       "--shading",  "--subdivide", "--model",       "--attenuation", "--without",      "--sampling",
        "--spp",          "--filter",   "--contrast",  "--max-level",   "--depth",       "--filter-width", "--cutoff",
        "--accel",        "--hemicube", "--patch",     "--accel-param", "--element",     "--solver",       "--opaque-shadows",
        "--form-factors", "--shots",    "--until",     "--no-ambient",  "--feed-lights", "--precision"};
    return settings.contains(flag);
}

bool is_of_the_view(std::string_view flag) {
    static const std::set<std::string_view> view = {"--camera", "--crop", "--frame", "--exposure", "--shader", "--slider"};
    return view.contains(flag);
}

void check_options(const std::string& file, const CostPoint& point) {
    for (const auto& [flag, text] : point.options)
        if (!is_neutral(flag) && !is_setting(flag) && !is_of_the_view(flag))
            throw UserError(file, fmt::format("the point {} has the option \"{}\", which no sweep has", point.value, flag));
}

// What the user did not say is as it was measured, and then the knob is turned.
Given options_of(const Knob& knob, const CostPoint& point, Given given) {
    for (const auto& [flag, text] : point.options)
        if (is_setting(flag)) given.try_emplace(flag, text);
    return with_value(knob, point.value, std::move(given));
}

// Those that only one of the two has count, too.
std::vector<std::string> differing_options(const CostPoint& point, const Given& given) {
    std::set<std::string> flags;
    for (const Given* options : {&point.options, &given})
        for (const auto& [flag, text] : *options) {
            const auto measured = point.options.find(flag), wanted = given.find(flag);
            const bool equal = measured != point.options.end() && wanted != given.end() && measured->second == wanted->second;
            if (!equal && !is_neutral(flag)) flags.insert(flag);
        }
    return {flags.begin(), flags.end()};
}

// Typed options in whose place the knob puts its own.
std::vector<std::string> replaced_options(const Given& typed, const Given& chosen) {
    std::vector<std::string> replaced;
    for (const auto& [flag, text] : typed) {
        const auto now = chosen.find(flag);
        if (now == chosen.end() || now->second != text) replaced.push_back(text.empty() ? flag : fmt::format("{} {}", flag, text));
    }
    return replaced;
}

std::string measured_for(const CostReport& report, const CostPoint& point, const Given& given, const Given& typed, double scale) {
    std::vector<std::string> parts;
    if (const auto replaced = replaced_options(typed, given); !replaced.empty())
        parts.push_back(fmt::format("{} is what the knob turns: {} takes its place", fmt::join(replaced, ", "), point.value));
    if (const auto scene = given.find("SCENE"); scene != given.end() && scene->second != report.scene)
        parts.push_back(fmt::format("it was measured for {}", report.scene));
    if (const auto flags = differing_options(point, given); !flags.empty())
        parts.push_back(fmt::format("it was measured with another {}", fmt::join(flags, ", ")));
    if (scale != 1)
        parts.push_back(fmt::format("times are those of {}x{} times {:.4g}, the ratio of pixels", report.width, report.height, scale));
    return fmt::format("{}", fmt::join(parts, "; "));
}

// What the user did not type and the report brings along.
std::string brought(const CostPoint& point, const Given& typed, const Given& chosen, const Knob& knob) {
    const Given turned = with_value(knob, point.value, {});
    std::string text;
    for (const auto& [flag, value] : chosen)
        if (!typed.contains(flag) && !turned.contains(flag)) text += fmt::format(" {}{}{}", flag, value.empty() ? "" : " ", value);
    return text.empty() ? "" : "; as measured:" + text;
}

} // namespace

BudgetChoice apply_budget(const BudgetArguments& a, Given& given, const std::function<glm::uvec2()>& film) {
    Wish wish = parse_wish(a);
    const CostReport report = read_report(a.cost);
    const CostCurve& curve = choose_curve(report, a);
    const Knob& knob = *find_knob(curve.knob);
    wish.metric = a.metric.empty() ? curve.metric : a.metric;
    wish.time_scale = time_scale_of(report, knob, given, film);
    const Choice choice = choose(curve, wish);
    if (!choice.point) throw UserError("--metric", fmt::format("no point of {} in {} has a \"{}\"", curve.knob, a.cost, wish.metric));
    if (!choice.fits)
        throw UserError(
            wish.error && !choice.near ? "--max-error" : "--budget",
            fmt::format("nothing in {} fits {}; the nearest is {}", a.cost, text_of(wish), text_of(curve, *choice.point, wish)));
    std::string problem;
    if (!parse_knob(fmt::format("{}={}", curve.knob, choice.point->value), problem)) throw UserError(a.cost, problem);
    const auto method = given.find("--method");
    if (method != given.end() && !knob.method.empty() && method->second != knob.method)
        throw UserError("--method", fmt::format("is {}, but the knob {} belongs to {}", method->second, curve.knob, knob.method));
    check_options(a.cost, *choice.point);
    const Given typed = std::exchange(given, options_of(knob, *choice.point, given));
    return {fmt::format("{}: {} of the {} points on the front that fit {}{}; a first run takes longer, since the driver compiles in it",
                        text_of(curve, *choice.point, wish), wish.error ? "the cheapest" : "the most accurate", choice.front, text_of(wish),
                        brought(*choice.point, typed, given, knob)),
            measured_for(report, *choice.point, given, typed, wish.time_scale), report.device, report.version};
}

std::string warning_of_device(const BudgetChoice& choice, const gpu::DeviceInfo& device) {
    if (choice.device == device.name && choice.version == device.version) return "";
    return fmt::format("it was measured on {} ({}), and this is {} ({}): times differ", choice.device, choice.version, device.name,
                       device.version);
}

} // namespace lightbench
