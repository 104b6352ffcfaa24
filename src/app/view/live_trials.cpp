// The part of LiveShaders that compiles and tries: what is shown first, the rest when it is.
#include "app/view/live.h"
#include "app/view/priority.h"

#include <fmt/format.h>
#include <future>

namespace lightbench::view {

namespace {

constexpr std::chrono::seconds kCompileTime(10), kLaterTime(60), kSecondChance(2);

// "gain at 2", "all sliders at their most".
std::string end_of(const std::vector<Slider>& sliders, bool most) {
    if (sliders.size() > 1) return most ? "all sliders at their most" : "all sliders at their least";
    return fmt::format("{} at {:g}", sliders.front().name, most ? sliders.front().most : sliders.front().least);
}

std::map<std::string, float> values_at(const std::vector<Slider>& sliders, bool most) {
    std::map<std::string, float> values;
    for (const Slider& slider : sliders) values[slider.name] = most ? slider.most : slider.least;
    return values;
}

} // namespace

// Nobody can tell which line a picture hangs on; but it is of the file that was saved last.
ShaderError LiveShaders::blamed(std::string text) const {
    std::string file = root_.string();
    if (touched_.starts_with("user/"))
        file = files_.at(std::stoul(touched_.substr(5))).string();
    else if (!touched_.empty())
        file = (root_ / touched_).string();
    else if (!files_.empty())
        file = files_.front().string();
    return {file, 0, std::move(text), ""};
}

bool LiveShaders::compile_others(const std::set<std::string>& names) {
    publish([&](LiveNews& news) { news.doing = fmt::format("compiling {} shaders that nothing shown uses", pending_.size()); });
    const auto stop = [this, stale = interruption()] {
        if (stale()) return true;
        const std::lock_guard lock(mutex_);
        return shows_untried(); // the method that is shown has changed
    };
    const auto compile = [&] {
        give_way(Priority::later); // the picture is being drawn with what was compiled before
        return tree_.compile(names, kLaterTime, stop);
    };
    CompiledShaders compiled = std::async(std::launch::async, compile).get();
    if (compiled.stopped) return true;
    if (!compiled.errors.empty()) return fail(std::move(compiled.errors));
    for (auto& [name, words] : compiled.modules) pending_.erase(name), ready_[name] = std::move(words);
    if (pending_.empty()) publish([](LiveNews& news) { news.errors.clear(); });
    return true;
}

// The trial's children start while the compiler runs.
bool LiveShaders::show(const std::set<std::string>& names, const Trial& trial) {
    TrialRun run(trial);
    if (names.empty()) return try_ready(run);
    publish([](LiveNews& news) { news.doing = "compiling shaders"; });
    CompiledShaders compiled = tree_.compile(names, kCompileTime, interruption());
    if (compiled.stopped) return true;
    if (!compiled.errors.empty()) return fail(std::move(compiled.errors));
    for (auto& [name, words] : compiled.modules) pending_.erase(name), ready_[name] = std::move(words);
    return try_ready(run);
}

// A machine that was busy, a child that was killed: what failed is tried once more, unless a save comes first.
bool LiveShaders::fail_for_now(const std::string& problem) {
    if (!second_) second_ = std::chrono::steady_clock::now() + kSecondChance;
    return fail({blamed(problem)});
}

// What the pictures use becomes good.
bool LiveShaders::try_ready(TrialRun& run) {
    publish([](LiveNews& news) { news.doing = "trying the shaders aside"; });
    const Trial& trial = run.trial();
    auto next = std::make_shared<ShaderSet>(set_);
    for (const auto& [name, words] : ready_) next->modules[name] = words;
    const Tried tried = run.finish(next->modules, constants_of(*next, trial.sliders), interruption());
    if (tried.stopped) return true;
    if (!tried.problem.empty()) return fail_for_now(tried.problem);
    std::set<std::string> changed;
    for (const std::string& name : tried.used)
        if (auto module = ready_.extract(name)) changed.insert(name), set_.modules[name] = std::move(module.mapped());
    *next = set_;
    tried_ = key_of(trial), ends_ = !set_.sliders.empty();
    publish([&](LiveNews& news) {
        news.errors.clear();
        if (changed.empty()) return;
        news.good = next, news.changed = changed, news.values = trial.sliders;
        news.sliders = ends_ ? SliderState::trying : SliderState::free;
    });
    return true;
}

bool LiveShaders::try_ends(const Trial& trial) {
    publish([](LiveNews& news) { news.doing = "trying the ends of the sliders aside"; });
    std::string problem;
    for (const bool most : {false, true}) {
        if (set_.modules.empty() || set_.sliders.empty() || !problem.empty()) break;
        const Tried tried = TrialRun(trial).finish(set_.modules, constants_of(set_, values_at(set_.sliders, most)), interruption());
        if (tried.stopped) return true;
        if (!tried.problem.empty()) problem = fmt::format("with {}, {}", end_of(set_.sliders, most), tried.problem);
    }
    ends_ = false;
    if (!problem.empty() && !second_) second_ = std::chrono::steady_clock::now() + kSecondChance;
    publish([&](LiveNews& news) { news.sliders = problem.empty() ? SliderState::free : SliderState::locked, news.locked = problem; });
    return true;
}

} // namespace lightbench::view
