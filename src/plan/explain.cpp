#include "plan/explain.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

using nlohmann::ordered_json;

constexpr int kFirstColumn = 11, kReasonColumn = 33;

// "42 136": thousands apart, as people read them.
std::string grouped(std::size_t n) {
    const std::string digits = fmt::format("{}", n);
    std::string spaced;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) spaced += ' ';
        spaced += digits[i];
    }
    return spaced;
}

std::string grouped_count(std::size_t n, std::string_view noun) {
    return fmt::format("{} {}{}", grouped(n), noun, n == 1 ? "" : "s");
}

// A title of a section, what it is, and why: the columns of the plan.
std::string title(std::string_view name, std::string_view what, std::string_view reason) {
    return fmt::format("{:<{}}{:<{}}{}\n", name, kFirstColumn, what, kReasonColumn - kFirstColumn, reason);
}

std::string entry(std::string_view mark, std::string_view name, std::string_view reason) {
    return fmt::format("  {:<{}}{}\n", fmt::format("{}{}", mark, name), kReasonColumn - 2, reason);
}

std::string entries(std::string_view mark, const std::vector<Line>& lines) {
    std::string text;
    for (const Line& line : lines) text += entry(mark, line.name, line.reason);
    return text;
}

std::string image_size(const Plan& plan) {
    std::string text = fmt::format("{}x{}", plan.size.x, plan.size.y);
    if (plan.crop.size == plan.size) return text;
    return text + fmt::format(", of it {}x{} at {},{}", plan.crop.size.x, plan.crop.size.y, plan.crop.offset.x, plan.crop.offset.y);
}

std::string work(const Plan& plan) {
    std::string text = plan.triangles ? grouped_count(*plan.triangles, "triangle") + ", " : "";
    text += grouped_count(plan.lights, "light") + ", " + image_size(plan);
    return plan.precision == Precision::float64 ? text + ", in float64" : text;
}

std::string passes(const Plan& plan) {
    std::string text = title("passes", "", "");
    for (const Pass& pass : plan.passes) text += entry("", pass.name, pass.reason);
    return text;
}

std::string resources(const Plan& plan) {
    std::string text = title("resources", "", "");
    for (const Resource& r : plan.resources)
        text += entry("", r.name, r.bytes > 0 ? fmt::format("{} bytes ({})", grouped(r.bytes), r.reason) : r.reason);
    return text;
}

std::string trimmed(const std::string& text) {
    std::string out;
    for (char c : text) {
        if (c == '\n') out.erase(out.find_last_not_of(' ') + 1);
        out += c;
    }
    return out;
}

ordered_json lines(const std::vector<Line>& from, const char* key) {
    ordered_json list = ordered_json::array();
    for (const Line& line : from) list.push_back({{key, line.name}, {"reason", line.reason}});
    return list;
}

ordered_json json_of(const Pass& pass) {
    return {{"name", pass.name}, {"reason", pass.reason}, {"reads", pass.reads}, {"writes", pass.writes}};
}

} // namespace

std::string_view name_of(Method method) {
    switch (method) {
    case Method::raster: return "raster";
    case Method::raytrace: return "raytrace";
    case Method::radiosity: break;
    }
    return "radiosity";
}

std::string_view name_of(Shading shading) {
    switch (shading) {
    case Shading::flat: return "flat";
    case Shading::gouraud: return "gouraud";
    case Shading::phong: break;
    }
    return "phong";
}

std::string explain(const Plan& plan) {
    std::string text = title("radiance", fmt::format("{}, {}", name_of(plan.method), name_of(plan.shading)), work(plan));
    text += entries("", plan.wanted) + entries("- ", plan.skipped);
    if (!plan.fallbacks.empty()) text += title("instead", "", "") + entries("", plan.fallbacks);
    text += passes(plan) + resources(plan);
    if (plan.output == Output::pixels) text += title("display", fmt::format("exposure {:g}, clamp", plan.exposure), "");
    return trimmed(text);
}

std::string explain_json(const Plan& plan) {
    ordered_json json = {{"method", name_of(plan.method)},
                         {"shading", name_of(plan.shading)},
                         {"precision", plan.precision == Precision::float64 ? "float64" : "float32"},
                         {"width", plan.size.x},
                         {"height", plan.size.y},
                         {"crop", {plan.crop.offset.x, plan.crop.offset.y, plan.crop.size.x, plan.crop.size.y}},
                         {"multisamples", plan.multisamples},
                         {"frames", plan.frames},
                         {"lights", plan.lights},
                         {"mask", plan.effects},
                         {"effects", lines(plan.wanted, "effect")},
                         {"skipped", lines(plan.skipped, "effect")},
                         {"fallbacks", lines(plan.fallbacks, "name")},
                         {"terms", plan.terms},
                         {"passes", ordered_json::array()},
                         {"resources", ordered_json::array()}};
    json["triangles"] = plan.triangles ? ordered_json(*plan.triangles) : ordered_json(nullptr);
    for (const Pass& pass : plan.passes) json["passes"].push_back(json_of(pass));
    for (const Resource& r : plan.resources) json["resources"].push_back({{"name", r.name}, {"bytes", r.bytes}, {"reason", r.reason}});
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

} // namespace lightbench
