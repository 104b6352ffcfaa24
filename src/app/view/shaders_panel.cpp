// What shaders that are edited show: their errors over the picture, sliders of their constants in the panel.
#include "app/view/interface.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace lightbench::view {

// Names stand above: there they have room.
void draw_sliders(State& state, const Shown& shown) {
    const std::vector<Slider>& sliders = shown.live.good->sliders;
    const bool free = shown.live.sliders == SliderState::free;
    ImGui::BeginDisabled(!free);
    for (const Slider& slider : sliders) {
        const auto known = state.sliders.find(slider.name);
        float value = known == state.sliders.end() ? slider.value : std::clamp(known->second, slider.least, slider.most);
        ImGui::TextWrapped("%s", slider.name.c_str());
        ImGui::SetNextItemWidth(-1);
        if (ImGui::SliderFloat(fmt::format("##{}", slider.constant).c_str(), &value, slider.least, slider.most, "%.4g",
                               ImGuiSliderFlags_AlwaysClamp))
            state.sliders[slider.name] = value;
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\nControl and a click: type the value", slider.file.c_str());
    }
    if (!sliders.empty() && ImGui::Button("first values")) state.sliders.clear();
    ImGui::EndDisabled();
    if (shown.live.sliders == SliderState::trying && !sliders.empty()) ImGui::TextDisabled("their ends are being tried aside");
    if (shown.live.sliders == SliderState::locked) ImGui::TextWrapped("they stay where they are: %s", shown.live.locked.c_str());
    if (shown.live.tree_edited)
        ImGui::TextWrapped("the folder of shaders is not the one that the program was built from: the copied command names it");
}

void draw_shader_errors(const Shown& shown, const PictureArea& area) {
    const ShaderErrors& errors = shown.live.errors;
    if (errors.empty()) return;
    const float margin = 12, width = std::max(area.room.x - 2 * margin, 32.0f);
    ImGui::SetNextWindowPos(ImVec2(area.room_at.x + margin, area.room_at.y + area.room.y - margin), ImGuiCond_Always, ImVec2(0, 1));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, std::max(area.room.y * 0.7f, 32.0f)));
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin("shader errors", nullptr,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    for (const ShaderError& error : errors) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.55f, 0.45f, 1));
        ImGui::TextWrapped("%s", error.line > 0 ? fmt::format("{}:{}: {}", error.file, error.line, error.message).c_str()
                                                : fmt::format("{}: {}", error.file, error.message).c_str());
        ImGui::PopStyleColor();
        if (!error.text.empty()) ImGui::TextWrapped("    %s", error.text.c_str());
    }
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("the picture is drawn by the last shaders that were good");
    ImGui::PopStyleColor();
    ImGui::End();
}

} // namespace lightbench::view
