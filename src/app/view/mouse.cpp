// What hands do on the picture: orbit, look, pan, dolly, wipe, click.
#include "app/view/camera.h"
#include "app/view/interface.h"

#include <algorithm>
#include <imgui.h>

namespace lightbench::view {
namespace {

constexpr float kGrip = 8;        // units about the wipe's line, at scale 1
constexpr double kTurn = 0.006;   // radians a unit of a drag
constexpr float kClickSlack = 16; // square of the units that a hand may shake in a click

Drag begun(const State& state, const PictureArea& area) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool inside = mouse.x >= area.room_at.x && mouse.x < area.room_at.x + area.room.x && mouse.y >= area.room_at.y &&
                        mouse.y < area.room_at.y + area.room.y;
    if (!inside) return Drag::none;
    const bool on_line = std::abs(mouse.x - (area.at.x + state.wipe * area.size.x)) <= kGrip * ImGui::GetIO().FontGlobalScale;
    return state.split && state.map == Map::wipe && on_line ? Drag::wipe : Drag::camera;
}

void drag_camera(State& state, const PictureArea& area, Hand& hand) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 move(io.MouseDelta.x, io.MouseDelta.y);
    if (move == glm::dvec2(0)) return;
    const glm::dvec2 turn = -kTurn * move;
    if (io.MouseDown[ImGuiMouseButton_Middle] || (io.MouseDown[ImGuiMouseButton_Left] && io.KeyShift))
        pan(state.camera, glm::dvec2(-move.x, move.y) / double(std::max(area.size.y, 1.0f)));
    else if (io.MouseDown[ImGuiMouseButton_Right])
        look_around(state.camera, turn);
    else if (io.MouseDown[ImGuiMouseButton_Left] && io.MouseDragMaxDistanceSqr[0] > kClickSlack)
        orbit(state.camera, turn);
    else
        return;
    hand.camera = true;
}

// Pixel of the picture under the mouse; nothing beside it.
std::optional<glm::uvec2> pixel_under(const PictureArea& area) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::vec2 share = (glm::vec2(mouse.x, mouse.y) - area.at) / glm::max(area.size, glm::vec2(1));
    if (share.x < 0 || share.y < 0 || share.x >= 1 || share.y >= 1) return std::nullopt;
    return glm::uvec2(glm::min(share * area.pixels, area.pixels - 1.0f));
}

} // namespace

void handle_mouse(State& state, const PictureArea& area, Hand& hand) {
    Drag& drag = state.drag;
    const ImGuiIO& io = ImGui::GetIO();
    for (int button = 0; button < 3; ++button)
        if (ImGui::IsMouseClicked(button) && !io.WantCaptureMouse) drag = begun(state, area);
    if (drag == Drag::wipe && io.MouseDown[0])
        state.wipe = std::clamp((io.MousePos.x - area.at.x) / std::max(area.size.x, 1.0f), 0.0f, 1.0f);
    if (drag == Drag::camera) drag_camera(state, area, hand);
    if (drag == Drag::camera && ImGui::IsMouseReleased(0) && io.MouseDragMaxDistanceSqr[0] <= kClickSlack) hand.click = pixel_under(area);
    if (!io.MouseDown[0] && !io.MouseDown[1] && !io.MouseDown[2]) drag = Drag::none;
    if (io.MouseWheel != 0 && !io.WantCaptureMouse && begun(state, area) != Drag::none)
        dolly(state.camera, double(io.MouseWheel)), hand.camera = true;
}

} // namespace lightbench::view
