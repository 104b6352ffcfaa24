// The exhibits of the gallery: which scene, in which shadings or by rays, what is to be seen in it. A table.
#pragma once

#include "plan/request.h"
#include "scene/make.h"

#include <optional>
#include <vector>

namespace lightbench {

// Rays through the scene instead of the rasteriser, if depth is not 0.
struct RayShot {
    unsigned depth = 0; // levels of the ray tree
    float cutoff = 0;
    unsigned spp = 1;
    bool counted = false; // rendered once more, untimed, for the number of rays of each kind
};

// Radiosity instead, if `shots` is not empty.
struct RadiosityShot {
    std::optional<unsigned> shots{};
    Show show = Show::light;
    double element = 0; // metres
};

struct ShotRow {
    const char* caption;
    const char* file; // without extension
    Shading shading;
    MakeArguments arguments = {};
    RayShot rays = {};
    RadiosityShot radiosity = {};
};

// One of the two is null.
struct ExhibitSource {
    const char* kind;  // of `make`
    const char* scene; // file in assets/scenes
};

struct ExhibitRow {
    const char* title;
    const char* text;
    ExhibitSource source;
    int reference; // index of the shot that the others are measured against; -1: none
    std::vector<ShotRow> shots;
};

const std::vector<ExhibitRow>& exhibit_rows();

} // namespace lightbench
