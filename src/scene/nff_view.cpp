// The view of an NFF file: `v` and the six lines after it.
#include "scene/check_geometry.h"
#include "scene/nff_parts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

namespace lightbench {
namespace {

constexpr std::string_view kParts[] = {"from", "at", "up", "angle", "hither", "resolution"};
constexpr NffField kPoint[] = {{"x"}, {"y"}, {"z"}};
constexpr NffField kAngle[] = {{"the vertical field of view", -1e300, 1e300, ""}};
constexpr NffField kHither[] = {{"the distance", 0, limits::kMaxCoordinate, "it must lie between 0 and 1e15 (limit kMaxCoordinate)"}};
constexpr NffField kSize[] = {{"the width", 1, limits::kMaxImageSide, "it must lie between 1 and 16384 (limit kMaxImageSide)"},
                              {"the height", 1, limits::kMaxImageSide, "it must lie between 1 and 16384 (limit kMaxImageSide)"}};

struct View {
    Camera camera;
    std::array<bool, 6> seen{}, good{}; // by kParts
    unsigned up_line = 0, at_line = 0;
};

std::size_t part_index(std::string_view word) {
    return static_cast<std::size_t>(std::find(std::begin(kParts), std::end(kParts), word) - std::begin(kParts));
}

bool read_point(NffLoad& load, std::string_view part, glm::dvec3& out) {
    double n[3];
    if (!read_numbers(load, part, kPoint, n)) return false;
    out = {n[0], n[1], n[2]};
    return true;
}

bool read_angle(NffLoad& load, Camera& camera) {
    double degrees = 0;
    if (!read_numbers(load, "angle", kAngle, {&degrees, 1})) return false;
    if (!(degrees > 0 && degrees < 180)) {
        fault_last(load, "angle is {}; it must lie between 0 and 180 degrees, both excluded", degrees);
        return false;
    }
    camera.fov = degrees * (glm::pi<double>() / 180);
    return true;
}

bool read_resolution(NffLoad& load) {
    double size[2];
    if (!read_numbers(load, "resolution", kSize, size)) return false;
    if (size[0] != std::floor(size[0]) || size[1] != std::floor(size[1])) {
        fault_last(load, "resolution must be two whole numbers");
        return false;
    }
    load.scene.film = glm::uvec2(static_cast<unsigned>(size[0]), static_cast<unsigned>(size[1]));
    return true;
}

bool read_part(NffLoad& load, std::size_t part, View& view) {
    switch (part) {
    case 0: return read_point(load, "from", view.camera.position);
    case 1: return view.at_line = load.in.line, read_point(load, "at", view.camera.target);
    case 2: return view.up_line = load.in.line, read_point(load, "up", view.camera.up);
    case 3: return read_angle(load, view.camera);
    case 4: return read_numbers(load, "hither", kHither, {&view.camera.hither, 1});
    default: return read_resolution(load);
    }
}

void check_view(NffLoad& load, const View& view) {
    for (std::size_t part : {0, 1, 2, 3, 5}) // hither may be left out
        if (!view.seen[part]) fault_word(load, "v: {} is missing", kParts[part]);
    if (!view.good[0] || !view.good[1] || !view.good[2]) return;
    if (has_no_direction(view.camera))
        fault_at(load, view.at_line, 1, "at is the same point as from; the camera must look somewhere");
    else if (up_is_along_view(view.camera))
        fault_at(load, view.up_line, 1, "up is along the view direction; it must point to another side");
}

} // namespace

void read_view(NffLoad& load) {
    if (!load.scene.cameras.empty()) return fault_word(load, "a second v; a file has one view");
    View view;
    view.camera.name = "view";
    while (skip_to_word(load.in)) {
        const std::string_view word = peek_word(load.in);
        const std::size_t part = part_index(word);
        if (part >= std::size(kParts)) break;
        if (view.seen[part]) fault_here(load, "a second {}; a view has one", word);
        take(load.in, word);
        view.seen[part] = true;
        view.good[part] = read_part(load, part, view);
        end_statement(load, word, view.good[part]);
    }
    load.scene.cameras.push_back(view.camera);
    check_view(load, view);
}

} // namespace lightbench
