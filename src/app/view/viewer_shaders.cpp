// Shaders that are edited while the viewer runs: from the thread that compiles them to the worker, and what is said about it.
#include "app/view/viewer.h"

#include "scene/write_number.h"

#include <bit>
#include <fmt/ranges.h>

namespace lightbench::view {
namespace {

std::string slider_text(const LiveNews& news) {
    if (news.sliders == SliderState::locked) return "locked: " + news.locked;
    return news.sliders == SliderState::free ? "free" : "trying";
}

} // namespace

// Without sources there is nothing to edit, which matters only to those who named files or sliders.
void Viewer::watch_shaders() {
    const SceneOptions& scene = options_.scene;
    state_.sliders = state_.first_sliders = scene.sliders;
    const bool asked = !scene.shaders.empty() || !scene.sliders.empty();
    const std::filesystem::path sources = shader_sources(asked);
    if (!sources.empty()) live_.emplace(sources, scene.shaders, scene.sliders, [] { Window::wake(); });
}

std::vector<std::string> Viewer::run_words() const {
    std::vector<std::string> words;
    if (options_.scene.allow_outside) words.push_back("--allow-outside");
    if (!options_.scene.device.empty()) words.push_back("--device"), words.push_back(options_.scene.device);
    return words;
}

// Files, and sliders that were moved.
std::vector<std::string> Viewer::shader_words() const {
    std::vector<std::string> words;
    for (const auto& file : options_.scene.shaders) words.push_back("--shader"), words.push_back(file.string());
    if (!live_news_.good) return words;
    const gpu::Constants constants = shaders().constants;
    for (const Slider& slider : live_news_.good->sliders)
        if (const auto value = std::bit_cast<float>(constants.at(slider.constant)); value != slider.value)
            words.push_back("--slider"), words.push_back(fmt::format("{}={}", slider.name, decimal(value)));
    return words;
}

// Values that hands chose count once any value has been tried.
Swap Viewer::shaders() const {
    if (!live_news_.good) return {};
    const auto& values = live_news_.sliders == SliderState::free ? state_.sliders : live_news_.values;
    return {live_news_.good, constants_of(*live_news_.good, values)};
}

Trial Viewer::trial() const {
    Trial trial{opened_.file, run_words(), {request_of(state_, state_.split ? 0 : state_.active, size_)}, state_.sliders};
    if (state_.split) trial.requests.push_back(request_of(state_, 1, size_));
    return trial;
}

bool Viewer::awaits_shaders() const {
    return live_ && news_.used && is_awaited(live_news_, *news_.used, trial());
}

void Viewer::take_shaders() {
    if (!live_) return;
    if (size_.x > 0) live_->tell(trial(), news_.used);
    LiveNews now = live_->news();
    if (now.number != live_news_.number) {
        const auto text = [](const ShaderErrors& errors) {
            std::string all;
            for (const ShaderError& error : errors) all += to_string(error) + "\n";
            return all;
        };
        const std::string before = text(live_news_.errors), after = text(now.errors);
        if (before != after)
            for (const ShaderError& error : now.errors)
                log_.say("shader-error {}:{}: {} | {}", error.file, error.line, error.message, error.text);
        if (after.empty() && !before.empty()) log_.say("shaders-mended");
        if (now.doing != live_news_.doing && !now.doing.empty()) log_.say("shaders: {}", now.doing);
        if (now.good && now.sliders != live_news_.sliders) log_.say("sliders {}", slider_text(now));
        live_news_ = std::move(now);
    }
    tell_swap();
}

// Once the picture is drawn with them.
void Viewer::tell_swap() {
    if (!news_.shaders || news_.shaders == told_swap_ || news_.shaders != live_news_.good) return;
    told_swap_ = news_.shaders;
    constexpr std::size_t most = 6;
    std::vector<std::string> names(live_news_.changed.begin(), live_news_.changed.end());
    const std::string more = names.size() > most ? fmt::format(" and {} more", names.size() - most) : "";
    names.resize(std::min(names.size(), most));
    const double seconds = std::chrono::duration<double>(Clock::now() - live_news_.seen).count();
    say(fmt::format("swapped {} shader{} in {:.1f} s", live_news_.changed.size(), live_news_.changed.size() == 1 ? "" : "s", seconds),
        fmt::format("{}", fmt::join(live_news_.changed, "\n")));
    log_.say("swapped {}{} in {:.2f} s", fmt::join(names, ", "), more, seconds);
}

} // namespace lightbench::view
