// The parts of the panel that explain: times, plan, the ray tree of a pixel, and its rays as lines over the picture.
#include "app/view/interface.h"
#include "app/view/marks.h"
#include "plan/explain.h"

#include <fmt/format.h>
#include <imgui.h>

namespace lightbench::view {
namespace {

std::string text_of(const glm::dvec3& v) {
    return fmt::format("{:.3g} {:.3g} {:.3g}", v.x, v.y, v.z);
}

// The side whose picture the panel explains.
const Shot* shot_of(const Shown& shown, const State& state) {
    const auto& shot = shown.news.shots[state.split ? state.active : 0];
    return shot ? shot.get() : nullptr;
}

void line(const std::string& text) {
    ImGui::TextWrapped("%s", text.c_str());
}

void draw_hit(const ProbedHit& hit, const Scene& scene) {
    line(fmt::format("object {}, {}, {:.4g} m", hit.object, scene.materials[hit.material].name, hit.distance));
    line(fmt::format("at {}", text_of(hit.position)));
    line(fmt::format("normal {}", text_of(hit.normal)));
    line(fmt::format("kd {}", text_of(hit.kd)));
    line(fmt::format("index {}", text_of(glm::dvec3(scene.materials[hit.material].ior))));
    for (std::size_t i = 0; i < hit.lights.size(); ++i)
        line(fmt::format("light {}: diffuse {}\n  specular {}", i, text_of(hit.lights[i].diffuse), text_of(hit.lights[i].specular)));
}

void draw_ray(const Probe& probe, std::size_t index, const Scene& scene) {
    const ProbedRay& ray = probe.rays[index];
    const std::string title = fmt::format("{}, weight {}##{}", ray.kind, text_of(ray.weight), index);
    if (!ImGui::TreeNodeEx(title.c_str(), index == 0 ? ImGuiTreeNodeFlags_DefaultOpen : 0)) return;
    line(fmt::format("level {}, radiance {}", ray.level, text_of(ray.radiance)));
    if (ray.hit)
        draw_hit(*ray.hit, scene);
    else
        line("stops: it leaves the scene");
    for (const ProbedStop& stop : ray.stops) ImGui::TextWrapped("no %s ray: %s", stop.branch.c_str(), stop.reason.c_str());
    for (const std::size_t child : ray.children) draw_ray(probe, child, scene);
    ImGui::TreePop();
}

unsigned color_of(const std::string& kind) {
    if (kind == "eye") return IM_COL32(255, 255, 255, 255);
    if (kind == "reflected") return IM_COL32(255, 150, 60, 255);
    return kind == "refracted" ? IM_COL32(90, 200, 255, 255) : IM_COL32(190, 255, 120, 255);
}

} // namespace

void draw_times(const Shown& shown, const State& state) {
    const Shot* shot = shot_of(shown, state);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    line(shown.devices);
    ImGui::PopStyleColor();
    if (shot == nullptr) return;
    line(fmt::format("{:.1f} ms on the device, {:.1f} in all{}", shot->output.device_milliseconds, shot->milliseconds,
                     shot->coarse ? ", in motion" : ""));
    for (const StepTime& step : shot->output.times) line(fmt::format("  {:<20}{:>9.2f}", step.name, step.milliseconds));
    if (const auto& radiosity = shot->output.radiosity)
        line(fmt::format("{} patches, {} shots, {:.2g} unshot", radiosity->patches, radiosity->shots, radiosity->unshot));
    if (const auto& accel = shot->output.accel) line(fmt::format("structure {:.1f} ms, {} nodes", accel->milliseconds, accel->nodes));
}

void draw_plan(const Shown& shown, const State& state) {
    const Shot* shot = shot_of(shown, state);
    if (shot == nullptr || shot->plan.passes.empty()) return;
    const std::string text = explain(shot->plan);
    ImGui::BeginChild("plan", ImVec2(0, 24 * ImGui::GetTextLineHeight()), true, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
    ImGui::EndChild();
}

void draw_inspector(const Answer& answer) {
    line(fmt::format("pixel {}, {}", answer.question.pixel.x, answer.question.pixel.y));
    if (!answer.problem.empty()) ImGui::TextWrapped("%s", answer.problem.c_str());
    if (answer.probe && !answer.probe->rays.empty()) draw_ray(*answer.probe, 0, *answer.question.scene.scene);
}

void draw_rays(const Shown& shown, const State& state, const PictureArea& area) {
    const auto& answer = shown.answer;
    const Shot* shot = shot_of(shown, state);
    if (!answer || !answer->probe || shot == nullptr || shot->view.size.x == 0) return;
    const Rect part = shot->plan.crop;
    const glm::dvec2 zoom = glm::dvec2(area.size) / glm::dvec2(part.size);
    const auto place = [&](const glm::dvec3& p) -> std::optional<ImVec2> {
        const auto pixel = pixel_of(shot->view, p);
        if (!pixel) return std::nullopt;
        const glm::dvec2 at = glm::dvec2(area.at) + (*pixel - glm::dvec2(part.offset)) * zoom;
        return ImVec2(static_cast<float>(at.x), static_cast<float>(at.y));
    };
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const double far = glm::length(shown.opened.bounds.max - shown.opened.bounds.min);
    for (const ProbedRay& ray : answer->probe->rays) {
        const auto from = place(ray.origin), to = place(ray.hit ? ray.hit->position : ray.origin + far * ray.direction);
        if (from && to) list->AddLine(*from, *to, color_of(ray.kind), 1.5f);
        if (to && ray.hit) list->AddCircleFilled(*to, 4, color_of(ray.kind));
    }
}

} // namespace lightbench::view
