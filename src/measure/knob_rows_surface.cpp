// Knobs of what a surface is shaded by: where the model is evaluated, which model, which law of attenuation, in which numbers.
#include "measure/knob_rows.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace lightbench {
namespace {

bool apply_shading(std::string_view value, OptionTexts& options) {
    const auto [mode, level] = split_value(value);
    if (!apply_name(mode, options, "--shading", {"flat", "gouraud", "phong"})) return false;
    if (level.empty()) return unset(options, {"--subdivide"}), true;
    if (level != "0" && !number_of(level)) return false;
    set(options, "--subdivide", level);
    return true;
}

double level_of(std::string_view value) {
    return number_of(split_value(value).second).value_or(0);
}

void refer_shading(OptionTexts& options, std::span<const std::string> values, bool again) {
    double finest = 0;
    for (const std::string& value : values) finest = std::max(finest, level_of(value));
    const double level = std::min(finest + 2, 8.0);
    set(options, "--shading", "phong");
    set(options, "--subdivide", fmt::format("{:g}", std::max(level - (again ? 1 : 0), 0.0)));
}

Knob shading() {
    return {.name = "shading",
            .meaning = "where the model is evaluated (polygon, vertex, pixel), and times that every surface is refined",
            .values = "flat, gouraud or phong, and /N for --subdivide N",
            .reference =
                "Phong at each pixel, in float64 where the device has it, refined two levels beyond the finest point (at most 8), the same "
                "samples; its uncertainty: one level less",
            .method = "raster",
            .defaults = {"flat/0", "flat/1", "flat/2", "flat/3", "flat/4", "gouraud/0", "gouraud/1", "gouraud/2", "gouraud/3", "gouraud/4",
                         "phong/0", "phong/2"},
            .apply = apply_shading,
            .refer = refer_shading,
            .in_float64 = true,
            .scale =
                [](std::string_view v, const OptionTexts&) {
                    return std::optional(Scale{std::string(split_value(v).first), std::exp2(level_of(v))});
                },
            .axis = "pieces of an edge",
            .slopes = {{"flat", "rmse", -1, "a constant in the place of a smooth function: first order in the length of an edge", 0.3},
                       {"gouraud", "rmse", -2, "linear interpolation of a smooth function: second order in the length of an edge", 0.5}}};
}

Knob model() {
    return {.name = "model",
            .meaning = "the local model of all materials; the other's highlight gets the same width",
            .values = "phong or cook-torrance",
            .reference = "the scene's own models, all else equal: a difference rather than an error; its uncertainty: the same again",
            .defaults = {"phong", "cook-torrance"},
            .apply =
                [](std::string_view value, OptionTexts& options) {
                    return apply_name(value, options, "--model", {"phong", "cook-torrance"});
                },
            .refer = [](OptionTexts& options, std::span<const std::string>, bool) { unset(options, {"--model"}); }};
}

Knob attenuation() {
    return {.name = "attenuation",
            .meaning = "the law by which all lights that have a place fall off",
            .values = "none, linear or inverse-square",
            .reference =
                "inverse-square, which is physics', all else equal: a difference rather than an error; its uncertainty: the same again",
            .defaults = {"none", "linear", "inverse-square"},
            .apply =
                [](std::string_view value, OptionTexts& options) {
                    return apply_name(value, options, "--attenuation", {"none", "linear", "inverse-square"});
                },
            .refer = [](OptionTexts& options, std::span<const std::string>, bool) { set(options, "--attenuation", "inverse-square"); }};
}

Knob precision() {
    return {.name = "precision",
            .meaning = "the numbers in which Phong's terms are evaluated at each pixel, from what is interpolated in float32",
            .values = "float32 or float64",
            .reference =
                "float64, all else equal, rounded to float32 where it is stored, by 6e-8 of a value; its uncertainty: the same again",
            .method = "raster",
            .defaults = {"float32", "float64"},
            .apply =
                [](std::string_view value, OptionTexts& options) {
                    return apply_name(value, options, "--precision", {"float32", "float64"});
                },
            .refer = [](OptionTexts& options, std::span<const std::string>, bool) { set(options, "--precision", "float64"); }};
}

} // namespace

std::vector<Knob> surface_knobs() {
    return {shading(), model(), attenuation(), precision()};
}

} // namespace lightbench
