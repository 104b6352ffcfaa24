// Shaders that are edited while the viewer runs: from the thread that compiles them to the worker, and what is said about it.
#include "app/view/viewer.h"

#include "scene/write_number.h"

#include <bit>
#include <fmt/ranges.h>

namespace lightbench::view {

// Without sources there is nothing to edit, which matters only to those who named files or sliders.
void Viewer::watch_shaders() {
    const SceneOptions& scene = options_.scene;
    state_.sliders = scene.sliders;
    const bool asked = !scene.shaders.empty() || !scene.sliders.empty();
    const std::filesystem::path sources = asked ? shader_sources() : find_shader_sources();
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
    const gpu::Constants constants = constants_of(*live_news_.good, state_.sliders);
    for (const Slider& slider : live_news_.good->sliders)
        if (const auto value = std::bit_cast<float>(constants.at(slider.constant)); value != slider.value)
            words.push_back("--slider"), words.push_back(fmt::format("{}={}", slider.name, decimal(value)));
    return words;
}

Swap Viewer::shaders() const {
    return live_news_.good ? Swap{live_news_.good, constants_of(*live_news_.good, state_.sliders)} : Swap{};
}

void Viewer::take_shaders() {
    if (!live_) return;
    live_->tell({opened_.file, run_words(), request_of(state_, state_.active, size_), state_.sliders}, news_.used);
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
    message_ = fmt::format("swapped {}{} in {:.1f} s", fmt::join(names, ", "), more, seconds);
    log_.say("{}", message_);
}

} // namespace lightbench::view
