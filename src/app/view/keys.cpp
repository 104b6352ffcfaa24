#include "app/view/keys.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

namespace lightbench::view {
namespace {

using A = Action;
using G = Group;

// clang-format off
constexpr KeyRow kKeys[] = {
    {A::raster,         GLFW_KEY_4,             0, "4", "raster", "draw with the rasteriser", G::shading},
    {A::raytrace,       GLFW_KEY_5,             0, "5", "rays", "trace rays: shadows, reflection, refraction", G::shading},
    {A::radiosity,      GLFW_KEY_6,             0, "6", "radiosity", "solve for diffuse light from wall to wall", G::shading},
    {A::flat,           GLFW_KEY_1,             0, "1", "flat", "shade once a polygon", G::shading},
    {A::gouraud,        GLFW_KEY_2,             0, "2", "Gouraud", "shade once a vertex", G::shading},
    {A::phong,          GLFW_KEY_3,             0, "3", "Phong", "shade once a pixel", G::shading},
    {A::model,          GLFW_KEY_M,             0, "M", "local model", "local model: as the scene says, Phong, Cook-Torrance", G::shading},
    {A::attenuation,    GLFW_KEY_L,             0, "L", "attenuation", "law of attenuation: as the scene says, none, linear, inverse-square", G::shading},
    {A::texture,        GLFW_KEY_T,             0, "T", "texture", "textures on, off", G::effects},
    {A::bump,           GLFW_KEY_B,             0, "B", "bump", "bumps on, off", G::effects},
    {A::environment,    GLFW_KEY_V,             0, "V", "environment", "environment on, off", G::effects},
    {A::transparency,   GLFW_KEY_O,             0, "O", "transparency", "transparency and refraction on, off", G::effects},
    {A::reflection,     GLFW_KEY_I,             0, "I", "reflection", "mirrors on, off", G::effects},
    {A::wireframe,      GLFW_KEY_X,             0, "X", "wireframe", "edges of the tessellation over the picture", G::effects},
    {A::normals,        GLFW_KEY_N,             0, "N", "normals", "normals of its vertices over the picture", G::effects},
    {A::subdivide_more, GLFW_KEY_EQUAL,         0, "=", "finer", "subdivide once more", G::detail},
    {A::subdivide_less, GLFW_KEY_MINUS,         0, "-", "coarser", "subdivide once less", G::detail},
    {A::samples_more,   GLFW_KEY_PERIOD,        0, ".", "more", "more samples a pixel", G::detail},
    {A::samples_less,   GLFW_KEY_COMMA,         0, ",", "fewer", "fewer samples a pixel", G::detail},
    {A::depth_more,     GLFW_KEY_RIGHT_BRACKET, 0, "]", "deeper", "one more level of the ray tree", G::detail},
    {A::depth_less,     GLFW_KEY_LEFT_BRACKET,  0, "[", "shallower", "one level less of the ray tree", G::detail},
    {A::structure,      GLFW_KEY_G,             0, "G", "structure", "the next structure that rays walk through", G::detail},
    {A::hemicube_more,  GLFW_KEY_0,             0, "0", "finer", "hemi-cubes of twice the pixels along an edge", G::detail},
    {A::hemicube_less,  GLFW_KEY_9,             0, "9", "coarser", "hemi-cubes of half the pixels along an edge", G::detail},
    {A::show,           GLFW_KEY_J,             0, "J", "show", "of radiosity: light, patches, and of the patch clicked on form factors and hemi-cube", G::detail},
    {A::split,          GLFW_KEY_C,             0, "C", "split", "two settings side by side, with a wipe between them", G::compare},
    {A::side,           GLFW_KEY_TAB,           0, "Tab", "side", "the keys set the other side", G::compare},
    {A::map,            GLFW_KEY_Z,             0, "Z", "map", "where the sides differ: wipe, difference, FLIP", G::compare},
    {A::frame,          GLFW_KEY_F,             0, "F", "frame", "bring the whole scene into view", G::window},
    {A::reset,          GLFW_KEY_R,             0, "R", "reset", "back to the camera and the settings at the start: one side, no lines, sliders as given", G::window},
    {A::panel,          GLFW_KEY_P,             0, "P", "panel", "fold the panel away, bring it back", G::window},
    {A::help,           GLFW_KEY_H,             0, "H", "help", "this list", G::window},
    {A::copy,           GLFW_KEY_C,             GLFW_MOD_CONTROL, "Ctrl+C", "copy command", "copy the command line that renders this very picture", G::window},
    {A::screenshot,     GLFW_KEY_F12,           0, "F12", "screenshot", "save the picture as a PNG", G::window},
    {A::vsync,          GLFW_KEY_Y,             0, "Y", "vsync", "wait for the screen, or not", G::window},
    {A::quit,           GLFW_KEY_ESCAPE,        0, "Esc", "quit", "quit", G::window},
    {A::forward,        GLFW_KEY_W,             0, "W", "forward", "fly forward", G::fly},
    {A::left,           GLFW_KEY_A,             0, "A", "left", "fly left", G::fly},
    {A::back,           GLFW_KEY_S,             0, "S", "back", "fly back", G::fly},
    {A::right,          GLFW_KEY_D,             0, "D", "right", "fly right", G::fly},
    {A::down,           GLFW_KEY_Q,             0, "Q", "down", "fly down", G::fly},
    {A::up,             GLFW_KEY_E,             0, "E", "up", "fly up", G::fly},
};

constexpr MouseRow kGestures[] = {
    {"drag", "orbit about the target"},
    {"right drag", "look around"},
    {"middle drag, Shift+drag", "move across"},
    {"wheel", "nearer, farther"},
    {"click", "the ray tree of that pixel; of radiosity, its patch"},
    {"drag the line", "move the wipe between the two sides"},
    {"drop a file", "open that scene"},
};
// clang-format on

} // namespace

std::span<const KeyRow> keys() {
    return kKeys;
}

std::span<const MouseRow> gestures() {
    return kGestures;
}

const KeyRow& row_of(Action action) {
    for (const KeyRow& row : kKeys)
        if (row.action == action) return row;
    return kKeys[0]; // a test holds that every action has its row
}

const KeyRow* find_key(int key, int modifiers) {
    for (const KeyRow& row : kKeys)
        if (row.key == key && row.modifiers == (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER))) return &row;
    return nullptr;
}

std::vector<HelpLine> help_lines() {
    std::vector<HelpLine> lines;
    for (const KeyRow& row : kKeys) lines.push_back({row.shortcut, row.help});
    for (const MouseRow& row : kGestures) lines.push_back({row.gesture, row.help});
    return lines;
}

std::string keys_markdown() {
    std::string text = "| key | |\n|---|---|\n";
    for (const KeyRow& row : kKeys) text += fmt::format("| `{}` | {} |\n", row.shortcut, row.help);
    for (const MouseRow& row : kGestures) text += fmt::format("| {} | {} |\n", row.gesture, row.help);
    return text;
}

} // namespace lightbench::view
