// Knobs of rays: how deep their tree grows, and what they walk through.
#include "measure/knob_rows.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {
namespace {

// As typed, above 0; `usual` if it was not.
double typed_number(const OptionTexts& options, std::string_view flag, double usual) {
    const auto typed = options.find(flag);
    return typed == options.end() ? usual : number_of(typed->second).value_or(usual);
}

// A tree that branches is kept finite by the cut-off, one between facing mirrors by the depth.
constexpr double kLevels = 64, kCutoff = 0.0005;

void refer_tree(OptionTexts& options, double levels, double cutoff, bool again) {
    set(options, "--depth", fmt::format("{:.0f}", again ? std::floor(0.75 * levels) : levels));
    set(options, "--cutoff", fmt::format("{:g}", again ? 2 * cutoff : cutoff));
}

void refer_depth(OptionTexts& options, std::span<const std::string> values, bool again) {
    double levels = kLevels;
    for (const std::string& value : values) levels = std::max(levels, 2 * number_of(value).value_or(0));
    refer_tree(options, std::min(levels, 255.0), std::min(typed_number(options, "--cutoff", kCutoff), kCutoff), again);
}

// A quarter, so that the second reference is not the finest point.
void refer_cutoff(OptionTexts& options, std::span<const std::string> values, bool again) {
    double cutoff = kCutoff;
    for (const std::string& value : values) cutoff = std::min(cutoff, number_of(value).value_or(1) / 4);
    refer_tree(options, std::max(typed_number(options, "--depth", kLevels), kLevels), cutoff, again);
}

Knob depth() {
    return {.name = "depth",
            .meaning = "levels of the ray tree, the eye ray the first",
            .values = "a whole number from 1 to 127",
            .reference = "64 levels, or twice the deepest point's, and a cut-off of 0.0005 or the smaller one that was typed, the same "
                         "samples; its uncertainty: three quarters of the levels and twice the cut-off",
            .method = "raytrace",
            .defaults = {"1", "2", "3", "4", "5", "6", "8", "10"},
            .apply = [](std::string_view value,
                        OptionTexts& options) { return apply_number(value, options, "--depth") && number_of(value) <= 127; },
            .refer = refer_depth,
            .scale = scale_of_number,
            .axis = "levels"};
}

Knob cutoff() {
    return {.name = "cutoff",
            .meaning = "weight below which a ray is not sent",
            .values = "a weight above 0, at most 1",
            .reference = "64 levels, or more if so many were typed, and a cut-off of 0.0005, or a quarter of the finest point's, the same "
                         "samples; its uncertainty: three quarters of the levels and twice the cut-off",
            .method = "raytrace",
            .defaults = {"0.5", "0.2", "0.1", "0.05", "0.02", "0.01", "0.005"},
            .base = [](OptionTexts& options, const Scene&) { set_if_absent(options, "--depth", "64"); },
            .apply = [](std::string_view value, OptionTexts& options) { return apply_number(value, options, "--cutoff"); },
            .refer = refer_cutoff,
            .scale = scale_of_inverse,
            .axis = "1 / cut-off"};
}

bool apply_structure(std::string_view value, OptionTexts& options) {
    unset(options, {"--accel-param"});
    return apply_name(value, options, "--accel", {"none", "bvh", "sphere-bvh", "grid", "octree"});
}

// "grid" with "density=4".
bool apply_parameter(std::string_view accel, std::string_view parameter, std::string_view value, OptionTexts& options) {
    set(options, "--accel", accel);
    set(options, "--accel-param", fmt::format("{}={}", parameter, value));
    return number_of(value).has_value();
}

bool apply_density(std::string_view value, OptionTexts& options) {
    return apply_parameter("grid", "density", value, options);
}

bool apply_octree_depth(std::string_view value, OptionTexts& options) {
    return apply_parameter("octree", "depth", value, options);
}

bool apply_leaf(std::string_view value, OptionTexts& options) {
    const auto [head, tail] = split_value(value);
    return (head == "bvh" || head == "sphere-bvh" || head == "octree") && apply_parameter(head, "leaf", tail, options);
}

constexpr std::string_view kStructure = "the picture by --accel bvh, which every other must equal in every bit: time is all that differs";

// What structures have in common: the picture.
Knob of_structures(Knob knob) {
    knob.method = "raytrace", knob.time_only = true;
    knob.refer = [](OptionTexts& options, std::span<const std::string>, bool) { unset(options, {"--accel", "--accel-param"}); };
    return knob;
}

std::vector<Knob> structures() {
    return {of_structures({.name = "accel",
                           .meaning = "the structure that rays walk through",
                           .values = "none, bvh, sphere-bvh, grid or octree",
                           .reference = kStructure,
                           .defaults = {"bvh", "sphere-bvh", "grid", "octree"},
                           .apply = apply_structure}),
            of_structures({.name = "grid-density",
                           .meaning = "cells of the grid for each primitive",
                           .values = "a number above 0, at most 1000",
                           .reference = kStructure,
                           .defaults = {"0.25", "0.5", "1", "2", "4", "8", "16", "32"},
                           .apply = apply_density}),
            of_structures({.name = "octree-depth",
                           .meaning = "levels of the octree at most",
                           .values = "a whole number from 1 to 20",
                           .reference = kStructure,
                           .defaults = {"2", "3", "4", "5", "6", "8", "10"}, // one level tests an eighth of a scene for every ray: minutes
                           .apply = apply_octree_depth}),
            of_structures({.name = "leaf",
                           .meaning = "primitives of a leaf at most (of an octree: of a voxel before it is split)",
                           .values = "bvh/N, sphere-bvh/N (N from 1 to 4) or octree/N",
                           .reference = kStructure,
                           .defaults = {"bvh/1", "bvh/2", "bvh/3", "bvh/4", "octree/2", "octree/4", "octree/8", "octree/16", "octree/32"},
                           .apply = apply_leaf})};
}

} // namespace

std::vector<Knob> ray_knobs() {
    std::vector<Knob> knobs = structures();
    knobs.insert(knobs.begin(), {depth(), cutoff()});
    return knobs;
}

} // namespace lightbench
