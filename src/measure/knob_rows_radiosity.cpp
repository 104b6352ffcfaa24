// Knobs of radiosity: hemi-cubes, patches, shots, solvers, the correction of near form factors.
#include "measure/knob_rows.h"

#include "radiosity/form_factors.h"
#include "scene/tessellate.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

// Of the sphere about the bounding box, metres; 1 for a scene without extent.
double bounding_radius(const Scene& scene) {
    const Bounds bounds = bounds_of(scene);
    const double radius = bounds.empty() ? 0 : glm::length(bounds.max - bounds.min) / 2;
    return radius > 0 ? radius : 1;
}

// A hundredth of the light is spread as ambient: what a picture is to look at, and a tenth of the time that the last thousandths take.
void until_a_hundredth(OptionTexts& options, const Scene&) {
    if (!options.contains("--shots")) set_if_absent(options, "--until", "0.01");
}

constexpr unsigned kFinestHemicube = 512; // of a point: hemi-cubes of twice as many pixels are the finest that there are
constexpr std::string_view kHemicubes =
    "hemi-cubes of twice as many pixels as the finest point's, of 512 at least, the same patches and shots; its uncertainty: 25/32 as many";

std::optional<double> pixels_of(std::string_view text) {
    const auto pixels = number_of(text);
    return pixels && *pixels <= kFinestHemicube ? pixels : std::nullopt;
}

// `finest`: pixels along an edge, of the finest point.
void refer_hemicube(OptionTexts& options, double finest, bool again) {
    const double pixels = std::clamp(2 * finest, 512.0, 2.0 * kFinestHemicube);
    set(options, "--hemicube", fmt::format("{:.0f}", again ? 2 * std::floor(pixels * 25 / 64) : pixels));
}

Errors sum_of_one_hemicube(std::string_view value) {
    const double n = number_of(value).value_or(0);
    return {{"sum", std::abs(sum_at_pixel_centers(static_cast<unsigned>(n)) - 1)}};
}

Knob hemicube() {
    return {.name = "hemicube",
            .meaning = "pixels along an edge of a hemi-cube",
            .values = "an even number from 8 to 512",
            .reference = kHemicubes,
            .method = "radiosity",
            .defaults = {"16", "32", "64", "128", "256"},
            .base = until_a_hundredth,
            .apply = [](std::string_view value,
                        OptionTexts& options) { return apply_number(value, options, "--hemicube") && pixels_of(value).has_value(); },
            .refer =
                [](OptionTexts& options, std::span<const std::string> values, bool again) {
                    double finest = 0;
                    for (const std::string& value : values) finest = std::max(finest, number_of(value).value_or(0));
                    refer_hemicube(options, finest, again);
                },
            .scale = scale_of_number,
            .computed = sum_of_one_hemicube,
            .axis = "pixels along an edge",
            .slopes =
                {{"", "rmse", std::nullopt,
                  "an element's edge cuts about N of its N^2 pixels: between -1, where it runs along them, and -1.5, where it does not"},
                 {"", "sum", -2,
                  "what the delta form factors of one hemi-cube, taken at the centers of its pixels (Cohen and Greenberg 1985), miss of 1: "
                  "a midpoint rule, of second order in the width of a pixel. The renderer integrates over each pixel: its sum is 1",
                  0.1, true}}};
}

std::string length_of(double metres) {
    return fmt::format("{:.3g}", metres);
}

void refer_patch(OptionTexts& options, std::span<const std::string> values, bool again) {
    double finest = number_of(values.front()).value_or(1);
    for (const std::string& value : values) finest = std::min(finest, number_of(value).value_or(finest));
    set(options, "--patch", length_of(finest * (again ? 0.7 : 0.5)));
    const auto typed = options.find("--hemicube");
    if (typed == options.end() || number_of(typed->second).value_or(0) < 256) set(options, "--hemicube", "256");
    unset(options, {"--element"});
}

Knob patch() {
    return {
        .name = "patch",
        .meaning = "longest edge of a patch, metres (of an element: a quarter of it)",
        .values = "a length in metres, above 0",
        .reference =
            "patches half as long as the finest point's, hemi-cubes of 256 at least, the same share unshot; its uncertainty: 0.7 as long",
        .method = "radiosity",
        .defaults_of =
            [](const Scene& scene) {
                // Half as long are four times as many elements, and as many shots: a reference beyond these is a matter of minutes.
                const double r = bounding_radius(scene);
                return std::vector<std::string>{length_of(r), length_of(0.7 * r), length_of(r / 2), length_of(0.35 * r), length_of(r / 4)};
            },
        .base = until_a_hundredth,
        .apply =
            [](std::string_view value, OptionTexts& options) {
                unset(options, {"--element"});
                return apply_number(value, options, "--patch");
            },
        .refer = refer_patch,
        .scale = scale_of_inverse,
        .axis = "1 / metres"};
}

bool apply_shots(std::string_view value, OptionTexts& options) {
    const auto [count, ambient] = split_value(value);
    set(options, "--shots", count);
    unset(options, {"--no-ambient", "--until"});
    if (!ambient.empty()) set(options, "--no-ambient", "");
    set(options, "--until", "0.0001");
    return number_of(count) && (ambient.empty() || ambient == "no-ambient");
}

void refer_shots(OptionTexts& options, std::span<const std::string>, bool again) {
    unset(options, {"--shots", "--no-ambient"});
    set(options, "--until", again ? "0.001" : "0.0001");
}

Knob shots() {
    return {.name = "shots",
            .meaning = "progressive shots, with the ambient term for what is still unshot and without",
            .values = "N, or N/no-ambient",
            .reference = "as many shots as leave 0.0001 of the light unshot, the same patches; its uncertainty: 0.001 unshot",
            .method = "radiosity",
            .defaults = {"1", "4", "16", "64", "256", "1024", "1/no-ambient", "4/no-ambient", "16/no-ambient", "64/no-ambient",
                         "256/no-ambient", "1024/no-ambient"},
            .apply = apply_shots,
            .refer = refer_shots,
            .scale =
                [](std::string_view v, const OptionTexts&) {
                    const auto [count, ambient] = split_value(v);
                    return std::optional(Scale{ambient.empty() ? "ambient" : "no-ambient", number_of(count).value_or(1)});
                },
            .axis = "shots"};
}

bool apply_solver(std::string_view value, OptionTexts& options) {
    const auto [name, until] = split_value(value);
    set(options, "--solver", name);
    unset(options, {"--shots", "--until", "--element"});
    if (name == "full") return until.empty();
    if (!until.empty()) set(options, "--until", until);
    if (const auto patch = options.find("--patch"); patch != options.end()) set(options, "--element", patch->second);
    return name == "progressive" && (until.empty() || number_of(until));
}

void refer_solver(OptionTexts& options, std::span<const std::string> values, bool again) {
    double share = 1e-4;
    for (const std::string& value : values) share = std::min(share, number_of(split_value(value).second).value_or(share));
    apply_solver(again ? "full" : fmt::format("progressive/{:g}", share / 10), options);
}

Knob solver() {
    return {
        .name = "solver",
        .meaning = "the full matrix at once, or shot by shot until a share of the light is unshot; every patch one element",
        .values = "full, progressive, or progressive/X (X for --until X)",
        .reference = "progressive until 0.00001 is unshot, or a tenth of the finest point's share, the same elements; its uncertainty: the "
                     "full matrix",
        .method = "radiosity",
        .defaults = {"full", "progressive/0.1", "progressive/0.01", "progressive/0.001"},
        .base = [](OptionTexts& options, const Scene& scene) { set_if_absent(options, "--patch", length_of(bounding_radius(scene) / 8)); },
        .apply = apply_solver,
        .refer = refer_solver,
        .scale = [](std::string_view v, const OptionTexts&) -> std::optional<Scale> {
            const auto until = number_of(split_value(v).second);
            return until ? std::optional(Scale{"progressive", 1 / *until}) : std::nullopt;
        },
        .axis = "1 / unshot share"};
}

bool apply_form_factors(std::string_view value, OptionTexts& options) {
    const auto [name, pixels] = split_value(value);
    set(options, "--form-factors", name);
    if (!pixels.empty()) set(options, "--hemicube", pixels);
    return (name == "corrected" || name == "hemicube") && (pixels.empty() || pixels_of(pixels));
}

constexpr std::string_view kUsualHemicube = "64"; // --hemicube where it is not typed

double pixels_of_options(const OptionTexts& options) {
    const auto typed = options.find("--hemicube");
    return number_of(typed == options.end() ? kUsualHemicube : std::string_view(typed->second)).value_or(1);
}

void refer_form_factors(OptionTexts& options, std::span<const std::string> values, bool again) {
    double finest = 0;
    for (const std::string& value : values) {
        OptionTexts of_point = options;
        apply_form_factors(value, of_point);
        finest = std::max(finest, pixels_of_options(of_point));
    }
    set(options, "--form-factors", "corrected");
    refer_hemicube(options, finest, again);
}

constexpr std::string_view kCorrected = "corrected, hemi-cubes of twice as many pixels as the finest point's, of 512 at least, the same "
                                        "patches and shots; its uncertainty: 25/32 "
                                        "as many";

Knob form_factors() {
    return {.name = "form-factors",
            .meaning = "analytic form factors where surfaces are near, or hemi-cubes alone; and pixels of the hemi-cube",
            .values = "corrected or hemicube, and /N for --hemicube N (N at most 512)",
            .reference = kCorrected,
            .method = "radiosity",
            .defaults = {"corrected/32", "corrected/64", "corrected/128", "hemicube/32", "hemicube/64", "hemicube/128"},
            .base = until_a_hundredth,
            .apply = apply_form_factors,
            .refer = refer_form_factors,
            .scale =
                [](std::string_view v, const OptionTexts& options) {
                    const auto [name, pixels] = split_value(v);
                    return std::optional(Scale{std::string(name), number_of(pixels).value_or(pixels_of_options(options))});
                },
            .axis = "pixels along an edge"};
}

} // namespace

std::vector<Knob> radiosity_knobs() {
    return {hemicube(), patch(), shots(), solver(), form_factors()};
}

} // namespace lightbench
