// The exhibits of the gallery: which scene, in which shadings, what is to be seen in it. A table.
#pragma once

#include "plan/request.h"
#include "scene/make.h"

#include <vector>

namespace lightbench {

struct ShotRow {
    const char* caption;
    const char* file; // without extension
    Shading shading;
    MakeArguments arguments = {};
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
