#include "app/stats.h"

#include "plan/explain.h"

#include <nlohmann/json.hpp>
#include <sys/resource.h>

namespace lightbench {
namespace {

using nlohmann::ordered_json;

// Largest resident set of this process. Linux counts it in KiB (getrusage(2)).
std::uint64_t host_peak() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

ordered_json plan_json(const Plan& plan) {
    ordered_json json = {{"effects", effect_names(plan)}, {"passes", ordered_json::array()}, {"skipped", ordered_json::array()}};
    for (const Pass& pass : plan.passes) json["passes"].push_back(pass.name);
    for (const Line& line : plan.skipped) json["skipped"].push_back({{"effect", line.name}, {"reason", line.reason}});
    return json;
}

ordered_json time_json(const RunRecord& run, const RenderOutput& output) {
    ordered_json passes = ordered_json::array();
    for (const StepTime& step : output.times) passes.push_back({{"name", step.name}, {"device", step.milliseconds}});
    return {{"load", run.load},           {"accel_build", output.accel ? ordered_json(output.accel->milliseconds) : ordered_json(nullptr)},
            {"pipelines", run.pipelines}, {"device", output.device_milliseconds},
            {"wall", run.wall},           {"passes", passes}};
}

// The rasteriser casts no ray and tests no primitive: counted, that is 0 of each.
ordered_json rays_json(bool counting, const RayStatistics& r) {
    if (!counting) return nullptr;
    return {{"eye", r.eye},          {"eye_hit", r.eye_hit}, {"shadow", r.shadow}, {"reflected", r.reflected}, {"refracted", r.refracted},
            {"straight", r.straight}};
}

// Polygons are tested as triangles, cylinders as cones of two equal radii, ellipsoids as balls.
ordered_json tests_json(bool counting, const RayStatistics& r) {
    if (!counting) return nullptr;
    return {{"sphere", r.spheres + r.balls},
            {"polygon", 0},
            {"triangle", r.triangles},
            {"box", r.boxes},
            {"cone", r.cones},
            {"cylinder", 0},
            {"torus", r.tori},
            {"node", r.nodes},
            {"voxel", r.voxels}};
}

ordered_json accel_json(const RenderOutput& output) {
    if (!output.accel) return nullptr;
    const AccelStatistics& a = *output.accel;
    return {{"bytes", a.bytes}, {"nodes", a.nodes}, {"references", a.references}, {"depth", a.depth}};
}

ordered_json radiosity_json(const RenderOutput& output) {
    if (!output.radiosity) return nullptr;
    const RadiosityStatistics& r = *output.radiosity;
    ordered_json curve = ordered_json::array();
    for (const auto& p : r.curve) curve.push_back({{"shots", p.shots}, {"unshot", p.unshot}, {"device", p.milliseconds}});
    return {{"patches", r.patches}, {"elements", r.elements},           {"shots", r.shots},
            {"unshot", r.unshot},   {"closure_error", r.closure_error}, {"device", r.milliseconds},
            {"curve", curve}};
}

} // namespace

std::string stats_json(const RunRecord& run, const Plan& plan, const gpu::DeviceInfo& device, const RenderOutput& output) {
    ordered_json json = {{"scene", run.scene},
                         {"method", name_of(plan.method)},
                         {"shading", name_of(plan.shading)},
                         {"width", plan.crop.size.x},
                         {"height", plan.crop.size.y},
                         {"frame", run.frame ? ordered_json(*run.frame) : ordered_json(nullptr)},
                         {"device", {{"name", device.name}, {"driver", device.driver}, {"version", device.version}}},
                         {"plan", plan_json(plan)},
                         {"time", time_json(run, output)},
                         {"counting", run.counting}};
    json["rays"] = rays_json(run.counting, output.rays.value_or(RayStatistics{}));
    json["tests"] = tests_json(run.counting, output.rays.value_or(RayStatistics{}));
    json["accel"] = accel_json(output);
    json["radiosity"] = radiosity_json(output);
    json["triangles"] = {{"scene", plan.triangles.value_or(0)}, {"drawn", output.triangles_drawn}};
    json["memory"] = {{"device_peak", run.device_peak}, {"host_peak", host_peak()}};
    json["shaders"] = run.shaders;
    json["image"] = {{"non_finite", output.non_finite}, {"done", output.done}};
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

} // namespace lightbench
