#include "app/view/interface.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace lightbench::view {
namespace {

constexpr float kPanelWidth = 330, kLeastPicture = 120; // at scale 1

// A button that shows what its key does and how it stands; greyed with the reason where it does nothing.
void action_button(Action action, const State& state, const Opened& opened, Hand& hand, float width) {
    const KeyRow& row = row_of(action);
    const auto reason = unavailable(action, state, opened);
    const std::string setting = setting_of(action, state);
    const bool on = setting == "on";
    const std::string text = fmt::format("{}  [{}]{}{}", row.label, row.shortcut, setting.empty() || on || setting == "off" ? "" : "  ",
                                         setting == "on" || setting == "off" ? "" : setting);
    if (reason) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4f);
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.16f, 0.44f, 0.72f, 1));
    if (ImGui::Button(fmt::format("{}##{}", text, static_cast<int>(action)).c_str(), ImVec2(width, 0)) && !reason)
        hand.actions.push_back(action);
    if (on) ImGui::PopStyleColor();
    if (reason) ImGui::PopStyleVar();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s%s%s", row.help, reason ? "\nnothing to do: " : "", reason ? reason->c_str() : "");
}

void action_row(std::initializer_list<Action> actions, const State& state, const Opened& opened, Hand& hand) {
    const auto n = static_cast<float>(actions.size());
    const float space = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - (n - 1) * space) / n;
    bool first = true;
    for (const Action action : actions) {
        if (!first) ImGui::SameLine();
        action_button(action, state, opened, hand, width);
        first = false;
    }
}

void draw_settings(const State& s, const Opened& o, Hand& hand) {
    using A = Action;
    if (s.split) ImGui::Text("the keys set side %s", s.active == 0 ? "A (left)" : "B (right)");
    action_row({A::raster, A::raytrace, A::radiosity}, s, o, hand);
    action_row({A::flat, A::gouraud, A::phong}, s, o, hand);
    action_row({A::model}, s, o, hand);
    action_row({A::attenuation}, s, o, hand);
    ImGui::Spacing();
    action_row({A::texture, A::bump}, s, o, hand);
    action_row({A::environment, A::reflection}, s, o, hand);
    action_row({A::transparency}, s, o, hand);
    action_row({A::wireframe, A::normals}, s, o, hand);
}

// What there is of: less, how much, more.
void stepper(const char* name, Action less, Action more, const State& s, const Opened& o, Hand& hand) {
    const auto reason = unavailable(more, s, o);
    const float unit = ImGui::GetFontSize();
    if (reason) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4f);
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s  %s", name, setting_of(more, s).c_str());
    if (reason && ImGui::IsItemHovered()) ImGui::SetTooltip("nothing to do: %s", reason->c_str());
    for (const Action action : {less, more}) {
        ImGui::SameLine(action == less ? 13 * unit : 17 * unit);
        const KeyRow& row = row_of(action);
        if (ImGui::Button(fmt::format("{} [{}]##{}", action == less ? "-" : "+", row.shortcut, static_cast<int>(action)).c_str(),
                          ImVec2(3.6f * unit, 0)) &&
            !reason)
            hand.actions.push_back(action);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", row.help);
    }
    if (reason) ImGui::PopStyleVar();
}

void draw_detail(const State& s, const Opened& o, Hand& hand) {
    using A = Action;
    stepper("subdivision", A::subdivide_less, A::subdivide_more, s, o, hand);
    stepper("samples a pixel", A::samples_less, A::samples_more, s, o, hand);
    stepper("ray depth", A::depth_less, A::depth_more, s, o, hand);
    stepper("hemi-cube pixels", A::hemicube_less, A::hemicube_more, s, o, hand);
    action_row({A::structure, A::show}, s, o, hand);
}

void draw_compare(const State& s, const Shown& shown, Hand& hand) {
    action_row({Action::split, Action::side}, s, shown.opened, hand);
    action_row({Action::map}, s, shown.opened, hand);
    if (!s.split) return;
    for (std::size_t i = 0; i < 2; ++i)
        if (const auto& shot = shown.news.shots[i]) ImGui::Text("%c  %.1f ms on the device", "AB"[i], shot -> output.device_milliseconds);
    if (const auto& versus = shown.news.versus)
        ImGui::Text("B against A: RMSE %.5f, FLIP %.4f", versus->rmse, versus->flip);
    else
        ImGui::TextDisabled("compared once both are at rest");
}

void draw_scene(const State& s, const Shown& shown, Hand& hand) {
    ImGui::TextWrapped("%s", shown.opened.file.filename().string().c_str());
    action_row({Action::copy}, s, shown.opened, hand);
    action_row({Action::screenshot}, s, shown.opened, hand);
    action_row({Action::frame, Action::reset, Action::vsync}, s, shown.opened, hand);
    action_row({Action::help, Action::panel}, s, shown.opened, hand);
    if (!shown.message.empty()) ImGui::TextWrapped("%s", shown.message.c_str());
    if (ImGui::TreeNode("recent files")) {
        for (const std::string& file : shown.recent) {
            if (ImGui::Selectable(std::filesystem::path(file).filename().string().c_str())) hand.open = file;
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", file.c_str());
        }
        ImGui::TreePop();
    }
}

void draw_problems(const Shown& shown) {
    if (shown.problems.empty() && shown.news.problem.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.55f, 0.45f, 1));
    for (const std::string& line : shown.problems) ImGui::TextWrapped("%s", line.c_str());
    if (!shown.news.problem.empty()) ImGui::TextWrapped("%s", shown.news.problem.c_str());
    ImGui::PopStyleColor();
    ImGui::TextDisabled("what is shown is from before");
    ImGui::Separator();
}

// What the picture waits for, once it does so long that one wonders.
std::string note(const Shown& shown) {
    if (shown.reading) return "reading the scene";
    if (!shown.live.doing.empty()) return shown.live.doing;
    const News& news = shown.news;
    if (!news.busy || news.pending_for < 300) return "";
    return news.progress > 0 ? fmt::format("{} {:.0f} %", news.doing, 100 * news.progress) : news.doing;
}

void draw_note(const Shown& shown, const PictureArea& area) {
    const std::string text = note(shown);
    if (text.empty()) return;
    const ImVec2 at(area.room_at.x + 8, area.room_at.y + 8), size = ImGui::CalcTextSize(text.c_str());
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddRectFilled(ImVec2(at.x - 4, at.y - 3), ImVec2(at.x + size.x + 4, at.y + size.y + 3), IM_COL32(0, 0, 0, 190), 3);
    list->AddText(at, IM_COL32(255, 220, 130, 255), text.c_str());
}

void draw_help(State& state, const PictureArea& area) {
    if (!state.help) return;
    const ImVec2 middle(area.room_at.x + area.room.x / 2, area.room_at.y + area.room.y / 2);
    ImGui::SetNextWindowPos(middle, ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(std::max(area.room.x - 16, 32.0f), std::max(area.room.y - 16, 32.0f)));
    ImGui::Begin("keys", &state.help,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings);
    const std::string text = keys_text();
    ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
    ImGui::End();
}

// A line between the sides, and their names.
void draw_wipe(const State& state, const PictureArea& area) {
    if (!state.split || state.map != Map::wipe || area.size.x <= 0) return;
    const float x = area.at.x + state.wipe * area.size.x, bottom = area.at.y + area.size.y;
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddLine(ImVec2(x, area.at.y), ImVec2(x, bottom), IM_COL32(255, 255, 255, 220), 2);
    list->AddCircleFilled(ImVec2(x, area.at.y + area.size.y / 2), 6, IM_COL32(255, 255, 255, 220));
    list->AddText(ImVec2(x - 18, bottom - 20), IM_COL32(255, 255, 255, 255), "A");
    list->AddText(ImVec2(x + 11, bottom - 20), IM_COL32(255, 255, 255, 255), "B");
}

void draw_panel(State& state, const Shown& shown, float width, float height, Hand& hand) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(width, height));
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings);
    draw_problems(shown);
    constexpr ImGuiTreeNodeFlags open = ImGuiTreeNodeFlags_DefaultOpen;
    if (ImGui::CollapsingHeader("scene", open)) draw_scene(state, shown, hand);
    if (ImGui::CollapsingHeader("light and surfaces", open)) draw_settings(state, shown.opened, hand);
    if (ImGui::CollapsingHeader("how finely", open)) draw_detail(state, shown.opened, hand);
    if (ImGui::CollapsingHeader("side by side", open)) draw_compare(state, shown, hand);
    if (shown.live.good && (!shown.live.good->sliders.empty() || shown.live.tree_edited) &&
        ImGui::CollapsingHeader("shader constants", open))
        draw_sliders(state, shown);
    if (shown.news.answer && ImGui::CollapsingHeader("rays of a pixel", open)) draw_inspector(shown);
    if (ImGui::CollapsingHeader("times", open)) draw_times(shown, state);
    if (ImGui::CollapsingHeader("plan")) draw_plan(shown, state);
    ImGui::End();
}

bool has_panel(const State& state, glm::vec2 window, float scale) {
    return state.panel && window.x >= (kPanelWidth + kLeastPicture) * scale;
}

} // namespace

void style_interface(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0, style.WindowBorderSize = 0, style.FrameRounding = 2;
    style.WindowPadding = ImVec2(8, 8), style.ItemSpacing = ImVec2(6, 4);
    style.WindowMinSize = ImVec2(1, 1);
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.11f, 0.11f, 0.125f, 1);
    style.Colors[ImGuiCol_Button] = ImVec4(0.22f, 0.23f, 0.26f, 1);
    style.ScaleAllSizes(scale);
    ImGui::GetIO().FontGlobalScale = scale;
    ImGui::GetIO().IniFilename = nullptr;
}

PictureArea picture_area(const State& state, glm::vec2 window, float scale, std::optional<glm::uvec2> picture) {
    PictureArea area;
    const float left = has_panel(state, window, scale) ? kPanelWidth * scale : 0;
    area.room_at = {left, 0}, area.room = glm::max(window - area.room_at, glm::vec2(1));
    area.pixels = picture ? glm::vec2(*picture) : area.room;
    const float zoom = std::min(area.room.x / area.pixels.x, area.room.y / area.pixels.y);
    area.size = picture ? area.pixels * zoom : area.room;
    area.at = area.room_at + glm::floor((area.room - area.size) / 2.0f);
    return area;
}

void draw_interface(State& state, const Shown& shown, const PictureArea& area, float scale, Hand& hand) {
    draw_wipe(state, area);
    draw_rays(shown, state, area);
    draw_note(shown, area);
    draw_shader_errors(shown, area);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    if (has_panel(state, {window.x, window.y}, scale)) draw_panel(state, shown, kPanelWidth * scale, window.y, hand);
    draw_help(state, area);
}

} // namespace lightbench::view
