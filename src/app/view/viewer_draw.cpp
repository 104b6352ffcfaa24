// One frame of the viewer's window.
#include "app/view/viewer.h"

#include "app/command_line.h"

#include <imgui.h>

namespace lightbench::view {
namespace {

// A part of the picture, from `left` to `right` of its width, where it belongs in the window.
Placement part(unsigned slot, const Image8& picture, const PictureArea& area, glm::vec2 scale, float left, float right) {
    const glm::vec2 at = area.at * scale, size = area.size * scale;
    const auto width = static_cast<float>(picture.width), height = static_cast<float>(picture.height);
    return {slot, at.x + left * size.x, at.y, at.x + right * size.x, at.y + size.y, left * width, 0, right * width, height};
}

} // namespace

void Viewer::show_picture(unsigned slot, const std::shared_ptr<const Image8>& picture) {
    if (!picture || on_screen_[slot] == picture) return;
    on_screen_[slot] = picture;
    presenter_->set_picture(slot, picture);
}

std::vector<Placement> Viewer::placements(const PictureArea& area) const {
    const ImVec2 s = ImGui::GetIO().DisplayFramebufferScale;
    const glm::vec2 scale(s.x, s.y);
    std::vector<Placement> all;
    const bool wipe = state_.split && state_.map == Map::wipe && on_screen_[1] && news_.shots[1];
    if (on_screen_[0]) all.push_back(part(0, *on_screen_[0], area, scale, 0, wipe ? state_.wipe : 1));
    if (wipe) all.push_back(part(1, *on_screen_[1], area, scale, state_.wipe, 1));
    return all;
}

void Viewer::draw() {
    presenter_->set_vsync(state_.vsync);
    presenter_->begin_frame();
    fit_size();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const Request& side = state_.sides[0];
    const PictureArea area = picture_area(state_, {window.x, window.y}, window_.scale(), side.crop ? side.crop->size : size_);
    const std::string devices = "renders on " + worker_->device_info().name;
    const Shown shown{opened_, news_, problems_, recent_, message_, file_.reading(), devices, live_news_, answer()};
    Hand hand;
    const bool wiping = state_.drag == Drag::wipe;
    handle_mouse(state_, area, hand);
    if (wiping && state_.drag != Drag::wipe) log_.say("wiped {:.3f}", state_.wipe);
    draw_interface(state_, shown, area, window_.scale(), hand);
    ImGui::Render();
    for (unsigned i = 0; i < 2; ++i)
        if (const auto& shot = news_.shots[i]) show_picture(i, shot->marked ? shot->marked : shot->pixels);
    if (state_.split && state_.map != Map::wipe && news_.versus)
        show_picture(0, state_.map == Map::flip ? news_.versus->flip_map : news_.versus->difference);
    shown_ = presenter_->present(placements(area));
    if (++frames_ % 500 == 0) log_.say("frames {}", frames_);
    for (const Action action : hand.actions) act(action);
    if (hand.camera) camera_moved();
    if (hand.click) inspect(*hand.click);
    if (hand.open) file_.open(*hand.open);
}

} // namespace lightbench::view
