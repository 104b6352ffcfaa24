// What the viewer shows at the moment, and what each action does to it. Pure: neither window nor device.
#pragma once

#include "app/view/keys.h"
#include "plan/plan.h"
#include "scene/tessellate.h"

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

namespace lightbench::view {

enum class Map { wipe, difference, flip };
enum class Drag { none, wipe, camera };

// A scene as it was read, and what is asked of it again and again.
struct Opened {
    std::filesystem::path file;
    std::shared_ptr<const Scene> scene;
    std::uint64_t version = 0;
    Facts facts;   // of the completed scene, without edits
    Bounds bounds; // world
    Camera camera; // that it starts with
    glm::uvec2 size{0};
};

// Throws UserError if the scene cannot be seen as asked.
Opened open_scene(std::filesystem::path file, Scene scene, const Request& request, std::uint64_t version);

struct State {
    std::array<Request, 2> sides{}; // without size and camera
    Request first{};                // the settings at the start
    std::map<std::string, float> first_sliders{};
    std::optional<glm::uvec2> size; // asked for; else the window's
    unsigned active = 0;            // side that the keys set
    bool split = false;
    float wipe = 0.5f; // share of the picture that side A has
    Map map = Map::wipe;
    Camera camera{};
    bool wireframe = false, normals = false, panel = true, help = false, vsync = true, quit = false;
    bool screen_waits = true; // vsync means something
    Drag drag = Drag::none;
    std::map<std::string, float> sliders{}; // values of shader constants, also of those that are gone for a while
    bool copy = false, screenshot = false;  // asked for, not done yet
    bool scroll = false;                    // the panel to what a click told
    Request& side() { return sides[active]; }
    const Request& side() const { return sides[active]; }
};

State start(const Request& request, const Opened& opened);

// Why the action would change nothing, in the plan's words; nothing: it does something.
std::optional<std::string> unavailable(Action action, const State& state, const Opened& opened);

// Does it, unless it is unavailable. Flying is done while keys are held, not here.
void apply(Action action, State& state, const Opened& opened, double aspect);

// How the setting of an action stands: "on", "bvh", "4"; empty for what has none.
std::string setting_of(Action action, const State& state);

// What is rendered of a side: with camera and size, and without options of other methods.
Request request_of(const State& state, unsigned side, glm::uvec2 size);

} // namespace lightbench::view
