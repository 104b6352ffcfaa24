// The options that render, plan and the sub-commands to come share. In: text as typed. Out: a Request and how to run it, or every problem.
#pragma once

#include "plan/request.h"
#include "scene/problem.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace lightbench {

// Options that were given, with their text; switches have an empty one.
using Given = std::map<std::string, std::string, std::less<>>;

enum class Progress { automatic, always, never };

struct FrameRange {
    int first = 0, last = 0; // inclusive
};

struct SceneOptions {
    std::filesystem::path scene;
    bool allow_outside = false;
    Request request;
    std::optional<FrameRange> frames;
    std::string device;                         // empty: by itself
    std::string solution;                       // file of --method radiosity, or empty
    std::string stats;                          // file, "-" or empty
    std::vector<std::filesystem::path> shaders; // whose functions take the place of the library's
    std::map<std::string, float> sliders;       // values of constants that shaders mark so
    bool count = false, quiet = false;
    Progress progress = Progress::automatic;
};

// Declares SCENE and all options; what is given arrives in `given`, the scene under "SCENE".
void declare_scene_options(CLI::App& sub, Given& given, bool scene_required = true);

// Every problem of what was given; options of methods that this version lacks are problems too: nothing is ignored.
SceneOptions parse_scene_options(const Given& given, Problems& problems);

// "flat, gouraud or phong"
std::string alternatives(const std::vector<std::string>& names);

} // namespace lightbench
