#include "sample_report.h"

#include "image/files.h"

#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

CostPoint sampled(const std::string& kind, int spp, double rmse, double ms, bool best) {
    CostPoint point;
    point.value = spp == 1 ? "none" : fmt::format("{}/{}", kind, spp);
    point.errors = {{"rmse", rmse}, {"relative rmse", rmse * 4}, {"maximum", std::min(1.0, rmse * 20)}, {"flip", rmse * 2.5}};
    point.device_ms = ms, point.q1_ms = ms * 0.97, point.q3_ms = ms * 1.06;
    point.runs = 9, point.settled = true;
    if (best) point.pareto = {"rmse", "relative rmse", "maximum", "flip"};
    point.image = fmt::format("images/spp-{}-{}.png", kind, spp);
    point.command =
        fmt::format("lightbench render assets/scenes/default.toml --method raytrace --sampling {} --spp {} --size 320x180 -o spp-{}-{}.png",
                    kind, spp, kind, spp);
    return point;
}

CostCurve samples_curve() {
    CostCurve curve;
    curve.knob = "spp", curve.meaning = "samples a pixel", curve.metric = "rmse";
    curve.reference = "1024 jittered samples a pixel, full depth, box filter";
    curve.reference_image = "images/spp-reference.png";
    curve.reference_command =
        "lightbench render assets/scenes/default.toml --method raytrace --sampling jittered --spp 1024 -o spp-reference.png";
    curve.reference_error = {{"rmse", 0.00031}, {"flip", 0.0011}};
    int row = 0;
    for (const int spp : {1, 4, 16, 64, 256}) {
        const double ms = 14.0 * std::pow(spp, 0.93);
        if (spp > 1) curve.points.push_back(sampled("uniform", spp, 0.051 * std::pow(spp, -0.62), ms * 0.99, row < 3));
        curve.points.push_back(sampled("jittered", spp, 0.05 * std::pow(spp, -0.72), ms, true));
        ++row;
    }
    curve.points.back().settled = false, curve.points.back().q3_ms *= 1.5;
    curve.points[1].pareto.clear(), curve.points[1].note = "error grows from none to uniform/4, where theory says that it falls";
    curve.points.push_back(sampled("adaptive", 64, 0.0036, 190, true));
    curve.slopes = {{"jittered", "rmse", "samples a pixel", -0.72, -0.75,
                     "an edge through a jittered pixel: Mitchell 1996, \"Consequences of stratified sampling in graphics\""},
                    {"uniform", "rmse", "samples a pixel", -0.62, -0.5, "an edge aligned with the grid misses by one row in sqrt(n)"},
                    {"", "flip", "samples a pixel", -0.68, std::nullopt, "FLIP is no norm: none is known"}};
    curve.notes = {"uniform/4: rmse is larger than that of none; it must fall with the samples",
                   "after 9 runs the 95 % interval of the median time is still wider than 5 % of it both ways: jittered/256"};
    return curve;
}

CostCurve structures_curve() {
    CostCurve curve;
    curve.knob = "accel", curve.meaning = "structure of the ray tracer", curve.metric = "rmse", curve.time_only = true;
    curve.reference = "no structure: every object is tested";
    curve.reference_image = "images/accel.png";
    double ms = 9;
    for (const char* value : {"bvh", "sphere-bvh", "grid/cells=32", "grid/cells=64", "octree/leaf=4", "octree/leaf=16", "none"}) {
        CostPoint point = sampled("accel", 1, 0, ms, ms == 9);
        point.value = value, point.image = "images/accel.png", ms *= 1.7;
        curve.points.push_back(point);
    }
    return curve;
}

CostCurve functions_curve() {
    CostCurve curve;
    curve.knob = "stable", curve.meaning = "naive against stable formula", curve.metric = "relative";
    curve.reference = "60 digits on the host";
    const std::tuple<const char*, double, double, double> rows[] = {{"fresnel naive", 1.0, 9e6, 0.81},
                                                                    {"fresnel stable", 6.1e-7, 11, 0.92},
                                                                    {"sphere naive", 0.13, 2e6, 1.40},
                                                                    {"sphere stable", 3.2e-7, 5, 1.52},
                                                                    {"checker naive", 0, 0, 0.70}};
    for (const auto& [value, relative, ulp, ms] : rows) {
        CostPoint point;
        point.value = value, point.errors = {{"relative", relative}, {"ulp", ulp}};
        point.device_ms = ms, point.q1_ms = ms * 0.99, point.q3_ms = ms * 1.02, point.runs = 21, point.settled = true;
        if (relative < 1e-5) point.pareto = {"relative", "ulp"};
        curve.points.push_back(point);
    }
    return curve;
}

// A gradient, and stripes that tell one picture from another.
void write_picture(const std::filesystem::path& file, unsigned number) {
    Image8 image{64, 36, std::vector<std::uint8_t>(std::size_t{64} * 36 * 4, 255)};
    for (unsigned i = 0; i < 64 * 36; ++i) {
        const unsigned x = i % 64, y = i / 64;
        const bool stripe = (x + y) / 3 % (number + 2) == 0;
        const unsigned channels[] = {stripe ? 250 : x * 4, y * 7, number * 23 % 256};
        for (unsigned c = 0; c < 3; ++c) image.rgba[std::size_t{i} * 4 + c] = static_cast<std::uint8_t>(channels[c]);
    }
    std::filesystem::create_directories(file.parent_path());
    write_png(file.string(), image);
}

} // namespace

CostReport sample_report() {
    CostReport report;
    report.program = "lightbench 0.1.0", report.scene = "assets/scenes/default.toml", report.width = 320, report.height = 180;
    report.device = "llvmpipe (LLVM 15.0.6, 256 bits)", report.driver = "llvmpipe", report.version = "Mesa 22.3.6";
    report.command = "lightbench cost assets/scenes/default.toml --size 320x180 --knob spp --knob accel --knob stable -o report";
    report.curves = {samples_curve(), structures_curve(), functions_curve()};
    return report;
}

void write_sample_pictures(const CostReport& report, const std::filesystem::path& folder) {
    unsigned number = 0;
    for (const CostCurve& curve : report.curves) {
        if (!curve.reference_image.empty()) write_picture(folder / curve.reference_image, number++);
        for (const CostPoint& point : curve.points)
            if (!point.image.empty() && !curve.time_only) write_picture(folder / point.image, number++);
    }
}

CostReport hostile_report() {
    CostReport report = sample_report();
    const std::string evil =
        "</script><script>window.hurt=1</script><img src=x onerror='window.hurt=1'>\"'&{{data}}`touch hurt`$(touch hurt)\n\x01\xff\xc0%s";
    report.program = report.scene = report.device = report.driver = report.version = report.command = evil;
    for (CostCurve& curve : report.curves) {
        curve.knob = "knob " + evil, curve.meaning = curve.reference = curve.reference_command = evil, curve.notes = {evil};
        for (Slope& slope : curve.slopes) slope.of = slope.against = slope.why = evil;
        for (CostPoint& point : curve.points) point.value = point.note = point.command = evil;
    }
    report.curves[0].points[0].errors[evil] = std::nan("");
    return report;
}

} // namespace lightbench
