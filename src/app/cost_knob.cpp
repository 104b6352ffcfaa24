#include "app/cost_knob.h"

#include "app/cost_variant.h"
#include "app/errors.h"
#include "app/interrupt.h"
#include "app/stats.h"
#include "gpu/float64.h"
#include "image/display.h"
#include "image/files.h"

#include <filesystem>
#include <fmt/format.h>
#include <set>

namespace lightbench {
namespace {

// "images/shading-gouraud-2.png": names that every file system takes.
std::string image_of(std::string_view knob, std::string_view value) {
    std::string name = fmt::format("{}-{}", knob, value);
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = '-';
    return fmt::format("images/{}.png", name);
}

std::string render_command(OptionTexts options, const std::string& image) {
    for (const char* flag : {"--quiet", "--progress"}) options.erase(flag);
    return "lightbench render " + command_of(options, std::filesystem::path(image).filename().string());
}

// A plan that falls back to another method would measure something else than what its curve says.
void check_method(const CostVariant& variant, const Knob& knob, const SceneOptions& options) {
    if (variant.plan().method == options.request.method) return;
    std::string why;
    for (const Line& line : variant.plan().fallbacks) why += fmt::format("; {}: {}", line.name, line.reason);
    throw UserError(fmt::format("--knob {}", knob.name), "the scene is not drawn by the method that the knob belongs to" + why);
}

References render_references(const PlannedKnob& planned, const KnobRun& run) {
    const auto render = [&](std::size_t i) {
        run.messages.step(fmt::format("{}: reference {} of 2", planned.knob->name, i + 1));
        CostVariant variant(run.device, run.scene, planned.references[i]);
        check_method(variant, *planned.knob, planned.references[i]);
        return variant.run().radiance;
    };
    return {render(0), render(1)};
}

void write_picture(const KnobRun& run, const std::string& image, const ImageF& radiance, float exposure) {
    begin_report(run.folder);
    write_png((run.folder.path / image).string(), display(radiance, exposure));
}

// Typed options that a value changes or takes back.
std::vector<std::string> overridden_options(const PlannedKnob& planned, const OptionTexts& typed) {
    std::set<std::string> flags;
    for (const std::string& value : planned.values) {
        const OptionTexts turned = with_value(*planned.knob, value, planned.base);
        for (const auto& [flag, text] : typed)
            if (const auto now = turned.find(flag); now == turned.end() || now->second != text) flags.insert(flag);
    }
    return {flags.begin(), flags.end()};
}

// A reference is computed in double where it can be.
void use_float64(PlannedKnob& planned, const gpu::Device& device) {
    if (!planned.knob->in_float64 || !gpu::has_float64(device)) return;
    for (std::size_t i = 0; i < 2; ++i) {
        planned.reference_texts[i].insert_or_assign("--precision", "float64");
        planned.references[i].request.precision = Precision::float64;
    }
}

// A problem of a value would be told of the references too, in numbers that nobody typed.
void plan_references(PlannedKnob& planned, const std::string& where, Problems& problems) {
    for (std::size_t i = 0; i < 2; ++i) {
        planned.reference_texts[i] = planned.base;
        planned.knob->refer(planned.reference_texts[i], planned.values, i == 1);
        planned.references[i] = parse_variant(planned.reference_texts[i], fmt::format("{}, its reference", where), problems);
    }
}

} // namespace

PlannedKnob plan_knob(const KnobUse& use, const Scene& scene, OptionTexts base, Problems& problems) {
    const Knob& knob = *use.knob;
    const OptionTexts typed = base;
    const std::size_t before = problems.size();
    const std::string where = fmt::format("--knob {}", knob.name);
    const auto method = base.find("--method");
    if (!knob.method.empty() && method != base.end() && method->second != knob.method)
        problems.push_back({where, 0, 0, fmt::format("belongs to --method {}, but --method is {}", knob.method, method->second)});
    if (!knob.method.empty()) base.insert_or_assign("--method", std::string(knob.method));
    if (knob.base) knob.base(base, scene);
    PlannedKnob planned{&knob, base, use.values.empty() ? default_values(knob, scene) : use.values, {}, {}, {}, {}};
    for (const std::string& value : planned.values)
        planned.variants.push_back(parse_variant(with_value(knob, value, base), fmt::format("{}={}", where, value), problems));
    if (problems.size() == before) plan_references(planned, where, problems);
    planned.overridden = overridden_options(planned, typed);
    return planned;
}

CostCurve planned_curve(const PlannedKnob& planned) {
    const Knob& knob = *planned.knob;
    CostCurve curve;
    curve.knob = knob.name, curve.meaning = knob.meaning, curve.metric = knob.metric, curve.time_only = knob.time_only;
    curve.reference = knob.reference;
    curve.reference_image = image_of(knob.name, "reference");
    curve.reference_command = render_command(planned.reference_texts[0], curve.reference_image);
    std::set<std::string> names{curve.reference_image};
    for (const std::string& value : planned.values) {
        CostPoint point;
        point.value = value, point.image = image_of(knob.name, value);
        for (int n = 2; !names.insert(point.image).second; ++n) // "2e+1" and "2e-1"
            point.image = image_of(knob.name, fmt::format("{}--{}", value, n));
        point.options = with_value(knob, value, planned.base);
        for (const char* flag : {"SCENE", "--quiet", "--progress"}) point.options.erase(flag);
        point.command = render_command(with_value(knob, value, planned.base), point.image);
        curve.points.push_back(std::move(point));
    }
    return curve;
}

Swept measure_knob(PlannedKnob planned, const KnobRun& run) {
    use_float64(planned, run.device);
    const float exposure = planned.references[0].request.exposure;
    const CostCurve curve = planned_curve(planned);
    const References references = render_references(planned, run);
    if (Interrupt::came()) return {curve, 0, true};
    std::vector<CostVariant> variants;
    for (const SceneOptions& options : planned.variants) {
        variants.emplace_back(run.device, run.scene, options);
        check_method(variants.back(), *planned.knob, options);
    }
    if (!variants.empty()) run.messages.fallbacks(variants.front().plan());
    write_picture(run, curve.reference_image, references.first, exposure);
    const Stopwatch watch;
    const SweepRunner runner{.run = [&](std::size_t i) { return variants[i].run(); },
                             .take_picture =
                                 [&](std::size_t i, const Rendering& rendering) {
                                     run.messages.step(
                                         fmt::format("{}: {} of {}, {}", planned.knob->name, i + 1, variants.size(), planned.values[i]));
                                     write_picture(run, curve.points[i].image, rendering.radiance, exposure);
                                 },
                             .wall = [&] { return watch.milliseconds(); },
                             .stop = Interrupt::came};
    Swept swept = sweep(curve, *planned.knob, references, runner, run.limits, exposure);
    if (swept.stopped) remove_pictures(curve, run.folder);
    return swept;
}

} // namespace lightbench
