#include "app/view/live.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace lightbench::view {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::chrono::milliseconds kWatchEvery(200);
constexpr std::chrono::seconds kCompileLimit(10), kPatience(3);
constexpr std::size_t kAtOnce = 4; // entry points that nothing shown uses: a save in between is seen soon

bool same_numbers(const std::vector<Slider>& a, const std::vector<Slider>& b) {
    return std::ranges::equal(a, b, [](const Slider& x, const Slider& y) { return x.file == y.file && x.name == y.name; });
}

Method method_of(const std::string& entry_point, Method shown) {
    if (entry_point.starts_with("raster/")) return Method::raster;
    if (entry_point.starts_with("raytrace/") || entry_point.starts_with("accel/")) return Method::raytrace;
    if (entry_point.starts_with("radiosity/")) return Method::radiosity;
    return shown;
}

} // namespace

gpu::Constants constants_of(const ShaderSet& set, const std::map<std::string, float>& values) {
    gpu::Constants constants;
    for (const Slider& slider : set.sliders) {
        const auto value = values.find(slider.name);
        const bool fits = value != values.end() && slider.least <= value->second && value->second <= slider.most;
        constants[slider.constant] = std::bit_cast<std::uint32_t>(fits ? value->second : slider.value);
    }
    return constants;
}

LiveShaders::LiveShaders(fs::path root, const std::vector<fs::path>& files, const std::map<std::string, float>& values,
                         std::function<void()> wake)
    : root_(std::move(root)), files_(files), tree_(tree_with(root_, files)), wake_(std::move(wake)) {
    set_.sliders = tree_.compile({}).sliders;
    slider_constants(set_.sliders, values); // throws if they are no sliders' values
    pending_ = edited_entry_points(tree_, root_, set_.sliders), reached_ = tree_.replaced();
    thread_ = std::thread([this] { run(); });
}

LiveShaders::~LiveShaders() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    something_.notify_one();
    thread_.join();
}

void LiveShaders::tell(Trial trial, std::shared_ptr<const std::set<std::string>> used) {
    {
        const std::lock_guard lock(mutex_);
        trial_ = std::move(trial);
        if (used == used_) return;
        used_ = std::move(used);
    }
    something_.notify_one();
}

LiveNews LiveShaders::news() const {
    const std::lock_guard lock(mutex_);
    return news_;
}

void LiveShaders::publish(const std::function<void(LiveNews&)>& change) {
    {
        const std::lock_guard lock(mutex_);
        change(news_), ++news_.number;
    }
    wake_();
}

// What to compile first is known once something has been drawn.
void LiveShaders::wait_for_a_picture() {
    std::unique_lock lock(mutex_);
    something_.wait_for(lock, kPatience, [&] { return stop_ || (used_ && !used_->empty()); });
    news_.seen = Clock::now();
}

void LiveShaders::run() {
    wait_for_a_picture();
    for (bool failed = false;;) {
        try {
            if (look()) failed = false;
            if (!failed && !pending_.empty()) failed = !step();
        } catch (const std::exception& error) { // no compiler, no room for its files
            failed = !fail({{"", 0, error.what(), ""}}) || failed;
        }
        std::unique_lock lock(mutex_);
        if (failed || pending_.empty()) something_.wait_for(lock, kWatchEvery, [&] { return stop_; });
        if (stop_) return;
    }
}

// True: something changed.
bool LiveShaders::look() {
    const std::vector<std::string> changed = tree_.refresh();
    if (changed.empty()) return false;
    const bool of_user = std::ranges::any_of(changed, [](const std::string& name) { return name.starts_with("user/"); });
    const bool of_tree = std::ranges::any_of(changed, [](const std::string& name) { return !name.starts_with("user/"); });
    touched_ = changed.back();
    pending_.merge(tree_.dependents(changed));
    if (of_user) { // a function may have left the file, and its original is back
        pending_.merge(std::exchange(reached_, tree_.replaced()));
        pending_.insert(reached_.begin(), reached_.end());
    }
    const CompiledShaders texts = tree_.compile({});
    if (!same_numbers(texts.sliders, set_.sliders)) { // constants have other numbers now, in all that was ever compiled
        for (const auto& [name, words] : set_.modules) pending_.insert(name);
        for (const auto& [name, words] : others_) pending_.insert(name);
        set_.modules.clear();
    }
    set_.sliders = texts.sliders;
    for (const std::string& name : pending_) others_.erase(name);
    publish([&](LiveNews& news) {
        news.seen = Clock::now(), news.tree_edited |= of_tree;
        if (pending_.empty()) news.errors = texts.errors; // else they stay until it is known whether they are mended
    });
    return true;
}

// The used ones together, else some of the others. False: something is wrong with them.
bool LiveShaders::step() {
    std::set<std::string> used, others;
    {
        const std::lock_guard lock(mutex_);
        for (const std::string& name : pending_)
            if (used_ && used_->contains(name))
                used.insert(name);
            else if (others.size() < kAtOnce)
                others.insert(name);
    }
    if (!used.empty()) publish([](LiveNews& news) { news.doing = "compiling shaders"; });
    const bool done = used.empty() ? compile_others(others) : compile_used(used);
    if (!used.empty()) publish([](LiveNews& news) { news.doing.clear(); });
    return done;
}

bool LiveShaders::fail(ShaderErrors errors) {
    publish([&](LiveNews& news) { news.errors = std::move(errors), news.doing.clear(); });
    return false;
}

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

bool LiveShaders::compile_used(const std::set<std::string>& names) {
    CompiledShaders compiled = tree_.compile(names, kCompileLimit);
    if (!compiled.errors.empty()) return fail(std::move(compiled.errors));
    auto next = std::make_shared<ShaderSet>(set_);
    for (auto& [name, words] : compiled.modules) next->modules[name] = std::move(words);
    Trial trial;
    {
        const std::lock_guard lock(mutex_);
        trial = trial_;
    }
    publish([](LiveNews& news) { news.doing = "trying the shaders aside"; });
    const std::string problem = try_shaders(trial, trial.request.method, next->modules, constants_of(*next, trial.sliders));
    if (!problem.empty()) return fail({blamed(problem)});
    for (const std::string& name : names) pending_.erase(name);
    set_ = *next;
    publish([&](LiveNews& news) { news.good = next, news.changed = names, news.errors.clear(); });
    return true;
}

// Once all are compiled they are tried, too, each with a method that uses it.
bool LiveShaders::compile_others(const std::set<std::string>& names) {
    CompiledShaders compiled = tree_.compile(names, kCompileLimit);
    if (!compiled.errors.empty()) return fail(std::move(compiled.errors));
    for (auto& [name, words] : compiled.modules) pending_.erase(name), others_[name] = std::move(words);
    if (!pending_.empty()) return true;
    auto next = std::make_shared<ShaderSet>(set_);
    std::set<std::string> changed;
    std::set<Method> methods;
    Trial trial;
    {
        const std::lock_guard lock(mutex_);
        trial = trial_;
    }
    for (const auto& [name, words] : others_)
        next->modules[name] = words, changed.insert(name), methods.insert(method_of(name, trial.request.method));
    for (const Method method : methods) {
        const std::string problem = try_shaders(trial, method, next->modules, constants_of(*next, trial.sliders));
        if (problem.empty()) continue;
        pending_ = changed, others_.clear();
        return fail({blamed(problem)});
    }
    set_ = *next, others_.clear();
    publish([&](LiveNews& news) { news.good = next, news.changed = changed, news.errors.clear(); });
    return true;
}

} // namespace lightbench::view
