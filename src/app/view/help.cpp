// The overlay that lists the keys.
#include "app/view/interface.h"

#include <algorithm>
#include <imgui.h>

namespace lightbench::view {

// Two lists beside one another where there is room, so that nothing scrolls; what a key does is wrapped.
void draw_help(State& state, float scale) {
    if (!state.help) return;
    constexpr float kOne = 620, kTwo = 1100; // units that one list takes at most, and that two need
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const int lists = window.x >= kTwo * scale ? 2 : 1;
    const float width = std::min(window.x - 16, static_cast<float>(lists) * kOne * scale);
    ImGui::SetNextWindowPos(ImVec2(window.x / 2, window.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(std::max(width, 32.0f), 0), ImVec2(std::max(width, 32.0f), std::max(window.y - 16, 32.0f)));
    ImGui::Begin("keys", &state.help,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings);
    const auto lines = help_lines();
    const std::size_t half = (lines.size() + static_cast<std::size_t>(lists) - 1) / static_cast<std::size_t>(lists);
    if (ImGui::BeginTable("list", 2 * lists, ImGuiTableFlags_RowBg)) {
        for (int i = 0; i < lists; ++i) {
            ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed);
            ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
        }
        for (std::size_t row = 0; row < half; ++row) {
            ImGui::TableNextRow();
            for (std::size_t at = row; at < lines.size(); at += half) {
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(lines[at].key);
                ImGui::TableNextColumn();
                ImGui::TextWrapped("%s", lines[at].help);
            }
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

} // namespace lightbench::view
