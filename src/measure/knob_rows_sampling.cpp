// Knobs of how a pixel is sampled: pattern and number, filter, thresholds of adaptive sampling.
#include "measure/knob_rows.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr double kMostSamples = 1024; // that --spp takes

// The two that come first of these and are not the typed one.
std::string another_seed(const OptionTexts& options, bool again) {
    const auto typed = options.find("--seed");
    const double own = typed == options.end() ? 0 : number_of(typed->second).value_or(0);
    std::vector<double> seeds{10001, 20002, 30003};
    std::erase(seeds, own);
    return fmt::format("{:.0f}", seeds[again ? 1 : 0]);
}

// So many jittered samples that an edge is known to 1024^-0.75 = 1/180 of a step; rays cost more, 400 know it to 1/90. Four times as many as
// the finest point takes (`finest`, a square) leave a third of its error at least.
void refer_jittered(OptionTexts& options, double finest, bool again) {
    const auto method = options.find("--method");
    const double usual = method != options.end() && method->second == "raytrace" ? 400 : kMostSamples;
    set(options, "--seed", another_seed(options, again));
    set(options, "--spp", fmt::format("{:.0f}", std::clamp(4 * finest, usual, kMostSamples)));
    set(options, "--sampling", "jittered");
    unset(options, {"--contrast", "--max-level"});
}

double samples_of(std::string_view value) {
    const auto [head, tail] = split_value(value);
    return number_of(tail.empty() ? head : tail).value_or(1);
}

void refer_samples(OptionTexts& options, std::span<const std::string> values, bool again) {
    double finest = 1;
    for (const std::string& value : values) finest = std::max(finest, samples_of(value));
    refer_jittered(options, finest, again);
}

constexpr std::string_view kReference =
    "1024 jittered samples a pixel (rays: 400, or four times the finest point's, 1024 at most) of another "
    "seed, all else equal; its uncertainty: a third seed";

bool apply_samples(std::string_view value, OptionTexts& options) {
    const auto [head, tail] = split_value(value);
    const bool named = !tail.empty();
    if (named && head != "uniform" && head != "jittered") return false;
    if (!number_of(named ? tail : head)) return false;
    set(options, "--spp", named ? tail : head);
    if (named)
        set(options, "--sampling", head);
    else if (const auto it = options.find("--sampling"); it != options.end() && (it->second == "none" || it->second == "adaptive"))
        options.erase(it);
    unset(options, {"--contrast", "--max-level"});
    return true;
}

std::optional<Scale> scale_of_samples(std::string_view value, const OptionTexts&) {
    const auto [head, tail] = split_value(value);
    return Scale{tail.empty() ? "" : std::string(head), samples_of(value)};
}

Knob samples() {
    return {
        .name = "spp",
        .meaning = "samples a pixel, and their pattern",
        .values = "uniform/N, jittered/N, or N alone with the pattern of --sampling (N a square)",
        .reference = kReference,
        .defaults = {"uniform/1", "uniform/4", "uniform/9", "uniform/16", "uniform/36", "uniform/64", "jittered/1", "jittered/4",
                     "jittered/9", "jittered/16", "jittered/36", "jittered/64"},
        .apply = apply_samples,
        .refer = refer_samples,
        .scale = scale_of_samples,
        .axis = "samples a pixel",
        .slopes = {
            {"jittered", "rmse", -0.75,
             "Mitchell 1996, \"Consequences of Stratified Sampling in Graphics\": only cells that an edge crosses err, sqrt(N) of N (where "
             "shading is smooth, errors fall faster)",
             0.25},
            {"uniform", "rmse", std::nullopt,
             "of an edge: -0.5 if it runs along the grid, since all cells that it crosses err alike; towards -1 if it does not"}}};
}

Knob filter() {
    return {.name = "filter",
            .meaning = "reconstruction: the mean over a pixel, or a Gaussian of that radius",
            .values = "box, or gaussian/R (R the radius in pixels, 1 to 16)",
            .reference = "400 jittered samples a pixel (or four times the points', 1024 at most) under the box filter, of another seed: "
                         "the mean over each pixel, from which a wider "
                         "filter departs on "
                         "purpose; its uncertainty: a third seed",
            .method = "raytrace",
            .defaults = {"box", "gaussian/1", "gaussian/1.5", "gaussian/2", "gaussian/3"},
            .base =
                [](OptionTexts& options, const Scene&) {
                    if (!options.contains("--sampling")) set(options, "--sampling", "jittered");
                    set_if_absent(options, "--spp", "16");
                },
            .apply =
                [](std::string_view value, OptionTexts& options) {
                    const auto [head, tail] = split_value(value);
                    unset(options, {"--filter-width"});
                    set(options, "--filter", head);
                    if (head == "box") return tail.empty();
                    if (!tail.empty()) set(options, "--filter-width", tail);
                    return head == "gaussian" && (tail.empty() || number_of(tail));
                },
            .refer =
                [](OptionTexts& options, std::span<const std::string>, bool again) {
                    const auto spp = options.find("--spp");
                    refer_jittered(options, spp == options.end() ? 1 : number_of(spp->second).value_or(1), again);
                    unset(options, {"--filter", "--filter-width"});
                }};
}

// Mitchell's thresholds keep their ratios: those of red, green and blue are 1, 0.8 and 1.6 times the value.
bool apply_contrast(std::string_view value, OptionTexts& options) {
    const auto [head, tail] = split_value(value);
    const auto x = number_of(head);
    if (!x || *x > 1) return false;
    set(options, "--sampling", "adaptive");
    set(options, "--contrast", fmt::format("{:.6g},{:.6g},{:.6g}", *x, 0.8 * *x, std::min(1.6 * *x, 1.0)));
    if (!tail.empty()) set(options, "--max-level", tail);
    unset(options, {"--spp", "--filter", "--filter-width"});
    return tail.empty() || tail == "0" || number_of(tail);
}

// A pixel that is split to the last level has 4^level corners.
void refer_contrast(OptionTexts& options, std::span<const std::string> values, bool again) {
    double level = 0;
    for (const std::string& value : values) {
        OptionTexts of_point = options;
        apply_contrast(value, of_point);
        const auto typed = of_point.find("--max-level");
        level = std::max(level, typed == of_point.end() ? 2 : number_of(typed->second).value_or(0));
    }
    refer_jittered(options, std::exp2(2 * std::min(level, 6.0)), again);
}

Knob contrast() {
    return {.name = "contrast",
            .meaning = "of adaptive sampling: the contrast above which a cell splits (red; green 0.8 of it, blue 1.6)",
            .values = "X (above 0, at most 1), and /N for --max-level N",
            .reference = kReference,
            .method = "raytrace",
            .defaults = {"1", "0.5", "0.25", "0.12", "0.06", "0.03"},
            .base =
                [](OptionTexts& options, const Scene&) {
                    set(options, "--sampling", "adaptive");
                    set_if_absent(options, "--max-level", "4");
                },
            .apply = apply_contrast,
            .refer = refer_contrast,
            .scale =
                [](std::string_view v, const OptionTexts&) {
                    return std::optional(Scale{std::string(split_value(v).second), 1 / number_of(split_value(v).first).value_or(1)});
                },
            .axis = "1 / threshold"};
}

} // namespace

std::vector<Knob> sampling_knobs() {
    return {samples(), filter(), contrast()};
}

} // namespace lightbench
