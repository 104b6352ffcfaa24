#include "measure/report_json.h"

#include "measure/pareto.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

using nlohmann::ordered_json;

constexpr unsigned kMostPixels = 1u << 20; // along an edge: more than any device draws

ordered_json json_of(double x) {
    return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr);
}

ordered_json json_of(const Errors& errors) {
    ordered_json object = ordered_json::object();
    for (const auto& [metric, error] : errors) object[metric] = json_of(error);
    return object;
}

ordered_json json_of(const CostPoint& p) {
    return {{"value", p.value},          {"errors", json_of(p.errors)}, {"device_ms", json_of(p.device_ms)},
            {"q1_ms", json_of(p.q1_ms)}, {"q3_ms", json_of(p.q3_ms)},   {"runs", p.runs},
            {"settled", p.settled},      {"pareto", p.pareto},          {"image", p.image},
            {"command", p.command},      {"options", p.options},        {"note", p.note}};
}

ordered_json json_of(const Slope& s) {
    return {{"of", s.of},
            {"metric", s.metric},
            {"against", s.against},
            {"measured", json_of(s.measured)},
            {"theory", s.theory ? json_of(*s.theory) : ordered_json(nullptr)},
            {"why", s.why}};
}

ordered_json json_of(const CostCurve& c) {
    ordered_json points = ordered_json::array(), slopes = ordered_json::array();
    for (const CostPoint& point : c.points) points.push_back(json_of(point));
    for (const Slope& slope : c.slopes) slopes.push_back(json_of(slope));
    return {{"knob", c.knob},
            {"meaning", c.meaning},
            {"metric", c.metric},
            {"time_only", c.time_only},
            {"reference",
             {{"how", c.reference}, {"image", c.reference_image}, {"command", c.reference_command}, {"error", json_of(c.reference_error)}}},
            {"points", points},
            {"slopes", slopes},
            {"notes", c.notes}};
}

double number_or_nan(const ordered_json& j) {
    return j.is_null() ? std::numeric_limits<double>::quiet_NaN() : j.get<double>();
}

[[noreturn]] void refuse(const ordered_json& j, const std::string& name, const std::string& wanted) {
    throw ReportError(fmt::format("is no report of lightbench cost: {} is {}; it must be {}", name, j.dump(), wanted));
}

// From 1 to `most`. (Of numbers that do not fit nlohmann's get<unsigned>() makes others.)
unsigned whole(const ordered_json& object, const char* name, unsigned most) {
    const ordered_json& j = object.at(name);
    if (!j.is_number_unsigned() || j.get<std::uint64_t>() < 1 || j.get<std::uint64_t>() > most)
        refuse(j, name, fmt::format("a whole number from 1 to {}", most));
    return j.get<unsigned>();
}

double milliseconds(const ordered_json& point, const char* name) {
    const ordered_json& j = point.at(name);
    if (!j.is_null() && !(j.is_number() && j.get<double>() > 0 && std::isfinite(j.get<double>())))
        refuse(j, name, "a time above 0, or null");
    return number_or_nan(j);
}

Errors errors_of(const ordered_json& j) {
    if (!j.is_object()) refuse(j, "errors", "an object: metrics and numbers");
    Errors errors;
    for (const auto& [metric, error] : j.items()) {
        if (!error.is_null() && !(error.is_number() && error.get<double>() >= 0)) refuse(error, metric, "a number of at least 0, or null");
        errors[metric] = number_or_nan(error);
    }
    return errors;
}

CostPoint point_of(const ordered_json& j) {
    return {.value = j.at("value"),
            .errors = errors_of(j.at("errors")),
            .device_ms = milliseconds(j, "device_ms"),
            .q1_ms = milliseconds(j, "q1_ms"),
            .q3_ms = milliseconds(j, "q3_ms"),
            .runs = whole(j, "runs", 1'000'000),
            .settled = j.at("settled"),
            .pareto = {},
            .image = j.at("image"),
            .command = j.at("command"),
            .options = j.at("options").get<std::map<std::string, std::string, std::less<>>>(),
            .note = j.at("note")};
}

Slope slope_of(const ordered_json& j) {
    Slope slope{j.at("of"), j.at("metric"), j.at("against"), number_or_nan(j.at("measured")), std::nullopt, j.at("why")};
    if (!j.at("theory").is_null()) slope.theory = j.at("theory").get<double>();
    return slope;
}

CostCurve curve_of(const ordered_json& j) {
    const ordered_json& reference = j.at("reference");
    CostCurve curve{.knob = j.at("knob"),
                    .meaning = j.at("meaning"),
                    .reference = reference.at("how"),
                    .reference_image = reference.at("image"),
                    .reference_command = reference.at("command"),
                    .reference_error = errors_of(reference.at("error")),
                    .metric = j.at("metric"),
                    .time_only = j.at("time_only"),
                    .points = {},
                    .slopes = {},
                    .notes = j.at("notes").get<std::vector<std::string>>()};
    for (const ordered_json& point : j.at("points")) curve.points.push_back(point_of(point));
    mark_fronts(curve.points); // a file may say anything
    for (const ordered_json& slope : j.at("slopes")) curve.slopes.push_back(slope_of(slope));
    return curve;
}

CostReport report_of(const ordered_json& j) {
    const ordered_json& device = j.at("device");
    CostReport report{.program = j.at("program"),
                      .scene = j.at("scene"),
                      .width = whole(j, "width", kMostPixels),
                      .height = whole(j, "height", kMostPixels),
                      .device = device.at("name"),
                      .driver = device.at("driver"),
                      .version = device.at("version"),
                      .command = j.at("command"),
                      .curves = {}};
    for (const ordered_json& curve : j.at("curves")) report.curves.push_back(curve_of(curve));
    return report;
}

} // namespace

std::string cost_json(const CostReport& report) {
    ordered_json curves = ordered_json::array();
    for (const CostCurve& curve : report.curves) curves.push_back(json_of(curve));
    const ordered_json json = {{"program", report.program},
                               {"scene", report.scene},
                               {"width", report.width},
                               {"height", report.height},
                               {"device", {{"name", report.device}, {"driver", report.driver}, {"version", report.version}}},
                               {"command", report.command},
                               {"curves", curves}};
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n"; // names of files are bytes, maybe not UTF-8
}

CostReport read_cost_json(std::string_view text) {
    try {
        return report_of(ordered_json::parse(text));
    } catch (const ordered_json::parse_error& error) {
        throw ReportError(fmt::format("is no JSON (byte {})", error.byte));
    } catch (const ordered_json::exception& error) {
        throw ReportError(fmt::format("is no report of lightbench cost: {}", error.what()));
    }
}

} // namespace lightbench
