#include "app/view/interface.h"
#include "app/view/panel_rows.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

namespace lightbench::view {
namespace {

constexpr float kLeastPicture = 120; // at scale 1

// A button that shows what its key does and how it stands; greyed with the reason where it does nothing.
void action_button(Action action, const State& state, const Opened& opened, Hand& hand, float width) {
    const auto reason = unavailable(action, state, opened);
    const bool on = setting_of(action, state) == "on";
    if (reason) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4f);
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.16f, 0.44f, 0.72f, 1));
    if (ImGui::Button(fmt::format("{}##{}", button_text(action, state), static_cast<int>(action)).c_str(), ImVec2(width, 0)) && !reason)
        hand.actions.push_back(action);
    if (on) ImGui::PopStyleColor();
    if (reason) ImGui::PopStyleVar();
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s%s%s", row_of(action).help, reason ? "\nnothing to do: " : "", reason ? reason->c_str() : "");
}

void draw_rows(Rows part, const State& state, const Opened& opened, Hand& hand) {
    for (const Row& row : rows_of(part)) {
        const auto n = static_cast<float>(row.size());
        const float width = (ImGui::GetContentRegionAvail().x - (n - 1) * ImGui::GetStyle().ItemSpacing.x) / n;
        for (const Action& action : row) {
            if (&action != &row.front()) ImGui::SameLine();
            action_button(action, state, opened, hand, width);
        }
    }
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
    draw_rows(Rows::detail, s, o, hand);
}

void draw_compare(const State& s, const Shown& shown, Hand& hand) {
    draw_rows(Rows::compare, s, shown.opened, hand);
    if (!s.split) return;
    for (std::size_t i = 0; i < 2; ++i)
        if (const auto& shot = shown.news.shots[i]) ImGui::Text("%c  %.1f ms on the device", "AB"[i], shot -> output.device_milliseconds);
    if (const auto& versus = shown.news.versus)
        ImGui::Text("B against A: RMSE %.5f, FLIP %.4f", versus->rmse, versus->flip);
    else
        ImGui::TextDisabled("compared once both are at rest");
}

// As high as ever, whatever there is to say: what lies below stays where it is.
void draw_message(const Message& message) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.6f, 0.85f, 0.6f, 1));
    ImGui::TextUnformatted(message.line.empty() ? " " : message.line.c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered() && !message.more.empty()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(40 * ImGui::GetFontSize());
        ImGui::TextUnformatted(message.more.c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

void draw_scene(const State& s, const Shown& shown, Hand& hand) {
    ImGui::TextWrapped("%s", shown.opened.file.filename().string().c_str());
    draw_message(shown.message);
    draw_rows(Rows::scene, s, shown.opened, hand);
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

// Over the picture, at its top, as wide as the room is at most. Errors have its bottom.
void draw_text_over(const std::string& text, const PictureArea& area) {
    if (text.empty()) return;
    const float wrap = std::max(area.room.x - 16, 32.0f);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const ImVec2 at(area.room_at.x + 8, area.room_at.y + 8);
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddRectFilled(ImVec2(at.x - 4, at.y - 3), ImVec2(at.x + size.x + 4, at.y + size.y + 3), IM_COL32(0, 0, 0, 190), 3);
    list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, IM_COL32(255, 220, 130, 255), text.c_str(), nullptr, wrap);
}

// What colors mean that are not light.
std::string legend(const State& state) {
    const Request& side = state.side();
    if (side.method != Method::radiosity) return "";
    const char* const texts[] = {
        "", "patches, a color each; their elements in two shades",
        "form factors of the patch that was clicked, blue: how much of its light arrives. From white, the most, over yellow and red to "
        "black, a "
        "ten thousandth or nothing. J: its hemi-cube, the light; click: another patch",
        "the hemi-cube of the patch that was clicked: its five faces unfolded, each pixel in the color of the patch that is seen there"};
    return texts[static_cast<std::size_t>(side.radiosity.show)];
}

// A line between the sides, and their names.
void draw_wipe(const State& state, const PictureArea& area) {
    if (!state.split || state.map != Map::wipe || area.size.x <= 0) return;
    const float x = area.at.x + state.wipe * area.size.x, bottom = area.at.y + area.size.y;
    const float unit = ImGui::GetIO().FontGlobalScale, middle = area.at.y + area.size.y / 2, text = middle - ImGui::GetFontSize() / 2;
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddLine(ImVec2(x, area.at.y), ImVec2(x, bottom), IM_COL32(255, 255, 255, 220), 2 * unit);
    list->AddCircleFilled(ImVec2(x, middle), 6 * unit, IM_COL32(255, 255, 255, 220));
    list->AddText(ImVec2(x - 18 * unit, text), IM_COL32(255, 255, 255, 255), "A");
    list->AddText(ImVec2(x + 11 * unit, text), IM_COL32(255, 255, 255, 255), "B");
}

void draw_panel(State& state, const Shown& shown, float width, float height, Hand& hand) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(width, height));
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysVerticalScrollbar);
    draw_problems(shown);
    constexpr ImGuiTreeNodeFlags open = ImGuiTreeNodeFlags_DefaultOpen;
    if (ImGui::CollapsingHeader("scene", open)) draw_scene(state, shown, hand);
    if (ImGui::CollapsingHeader("light and surfaces", open)) {
        if (state.split) ImGui::Text("the keys set side %s", state.active == 0 ? "A (left)" : "B (right)");
        draw_rows(Rows::surfaces, state, shown.opened, hand);
    }
    if (ImGui::CollapsingHeader("how finely", open)) draw_detail(state, shown.opened, hand);
    if (ImGui::CollapsingHeader("side by side", open)) draw_compare(state, shown, hand);
    if (shown.live.good && (!shown.live.good->sliders.empty() || shown.live.tree_edited) &&
        ImGui::CollapsingHeader("shader constants", open))
        draw_sliders(state, shown);
    if (std::exchange(state.scroll, false)) ImGui::SetNextItemOpen(true), ImGui::SetScrollHereY(0);
    if (shown.answer && ImGui::CollapsingHeader("rays of a pixel", open)) draw_inspector(*shown.answer);
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
    style.WindowPadding = ImVec2(kPanelPadding, 8), style.ItemSpacing = ImVec2(kSpacing, 4);
    style.FramePadding = ImVec2(kFramePadding, 3), style.ScrollbarSize = kScrollBar, style.IndentSpacing = 10;
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
    const std::string colors = legend(state), waiting = note(shown);
    draw_text_over(colors + (colors.empty() || waiting.empty() ? "" : "\n") + waiting, area);
    draw_shader_errors(shown, area);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    if (has_panel(state, {window.x, window.y}, scale)) draw_panel(state, shown, kPanelWidth * scale, window.y, hand);
    draw_help(state, scale);
}

} // namespace lightbench::view
