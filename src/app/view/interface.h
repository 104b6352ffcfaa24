// The interface over and beside the picture. In: the state, what the worker has. Out: the state as hands changed it, and where the picture is.
#pragma once

#include "app/view/files.h"
#include "app/view/live.h"
#include "app/view/state.h"
#include "app/view/worker.h"

namespace lightbench::view {

// Where the picture is in the window, in the interface's units; zoom: of these a pixel of the picture.
struct PictureArea {
    glm::vec2 at{0}, size{0};
    glm::vec2 room_at{0}, room{0}; // that the picture may have
    glm::vec2 pixels{0};           // of the picture
};

struct Hand {
    std::vector<Action> actions;
    std::optional<glm::uvec2> click; // pixel of the picture
    std::optional<std::string> open; // a file
    bool camera = false;             // was moved
};

// About what was done last: a line, and what there is to say besides.
struct Message {
    std::string line{}, more{};
};

struct Shown {
    const Opened& opened;
    const News& news;
    const std::vector<std::string>& problems; // of the scene file, and of what else went wrong
    const std::vector<std::string>& recent;
    const Message& message;
    bool reading = false;
    std::string devices;
    const LiveNews& live;
    std::shared_ptr<const Answer> answer; // of what is shown; null: there is none
};

void style_interface(float scale);

// The room that is left for the picture beside the panel.
PictureArea picture_area(const State& state, glm::vec2 window, float scale, std::optional<glm::uvec2> picture);

// Panel, notes, help, marks of the picture: everything.
void draw_interface(State& state, const Shown& shown, const PictureArea& area, float scale, Hand& hand);

// Drags, wheel and clicks on the picture.
void handle_mouse(State& state, const PictureArea& area, Hand& hand);

// Parts of the panel.
void draw_inspector(const Answer& answer);
void draw_rays(const Shown& shown, const State& state, const PictureArea& area);
void draw_times(const Shown& shown, const State& state);
void draw_plan(const Shown& shown, const State& state);
void draw_sliders(State& state, const Shown& shown);
// Over the picture.
void draw_shader_errors(const Shown& shown, const PictureArea& area);
void draw_help(State& state, float scale);

} // namespace lightbench::view
