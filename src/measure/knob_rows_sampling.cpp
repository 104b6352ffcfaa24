// Knobs of how a pixel is sampled: pattern and number, filter, thresholds of adaptive sampling.
#include "measure/knob_rows.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {
namespace {

// So many jittered samples that an edge is known to 1024^-0.75 = 1/180 of a step; rays cost more, 400 know it to 1/90.
void refer_samples(OptionTexts& options, std::span<const std::string>, bool again) {
    unset(options, {"--contrast", "--max-level"});
    const auto method = options.find("--method");
    set(options, "--spp", method != options.end() && method->second == "raytrace" ? "400" : "1024");
    set(options, "--sampling", "jittered");
    set(options, "--seed", again ? "20002" : "10001");
}

constexpr std::string_view kReference =
    "1024 jittered samples a pixel (rays: 400) of another seed, all else equal; its uncertainty: a third seed";

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

std::optional<Scale> scale_of_samples(std::string_view value) {
    const auto [head, tail] = split_value(value);
    if (tail.empty()) return Scale{"", number_of(head).value_or(1)};
    return Scale{std::string(head), number_of(tail).value_or(1)};
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
             "shading is smooth, errors fall faster)"},
            {"uniform", "rmse", std::nullopt,
             "of an edge: -0.5 if it runs along the grid, since all cells that it crosses err alike; towards -1 if it does not"}}};
}

Knob filter() {
    return {.name = "filter",
            .meaning = "reconstruction: the mean over a pixel, or a Gaussian of that radius",
            .values = "box, or gaussian/R (R the radius in pixels, 1 to 16)",
            .reference = "400 jittered samples a pixel under the box filter, of another seed: the mean over each pixel, from which a wider "
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
                [](OptionTexts& options, std::span<const std::string> values, bool again) {
                    unset(options, {"--filter", "--filter-width"});
                    refer_samples(options, values, again);
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
            .refer = refer_samples,
            .scale =
                [](std::string_view v) {
                    return std::optional(Scale{std::string(split_value(v).second), 1 / number_of(split_value(v).first).value_or(1)});
                },
            .axis = "1 / threshold"};
}

} // namespace

std::vector<Knob> sampling_knobs() {
    return {samples(), filter(), contrast()};
}

} // namespace lightbench
