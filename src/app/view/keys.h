// The one table of what the viewer does on a key or a gesture: it drives the input, the panel, the help overlay and the list in the README.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace lightbench::view {

// clang-format off
enum class Action {
    flat, gouraud, phong, raster, raytrace, radiosity, model, attenuation, texture, bump, environment, transparency, reflection,
    wireframe, normals, subdivide_more, subdivide_less, samples_more, samples_less, depth_more, depth_less, structure,
    hemicube_more, hemicube_less, show, split, side, map, frame, reset, panel, help, copy, screenshot, vsync, quit,
    forward, back, left, right, up, down
};
// clang-format on

enum class Group { shading, effects, detail, compare, window, fly };

struct KeyRow {
    Action action;
    int key, modifiers; // of GLFW
    const char* shortcut;
    const char* label; // short, for the panel
    const char* help;
    Group group;
};

struct MouseRow {
    const char* gesture;
    const char* help;
};

std::span<const KeyRow> keys();
std::span<const MouseRow> gestures();
const KeyRow& row_of(Action action);

// The row of a key that was pressed; null: it means nothing.
const KeyRow* find_key(int key, int modifiers);

// "| key | |", a row each, as the README has it.
std::string keys_markdown();
// Keys and gestures, as the overlay shows them.
struct HelpLine {
    const char* key;
    const char* help;
};
std::vector<HelpLine> help_lines();

} // namespace lightbench::view
