#include "app/view/live.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace lightbench::view {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::chrono::milliseconds kWatchEvery(50);
constexpr std::chrono::seconds kFirstPicture(3);
constexpr std::size_t kAtOnce = 4; // entry points that nothing shown uses: a save in between is seen soon

bool same_numbers(const std::vector<Slider>& a, const std::vector<Slider>& b) {
    return std::ranges::equal(a, b, [](const Slider& x, const Slider& y) { return x.file == y.file && x.name == y.name; });
}

template <class Names> bool any_in(const std::set<std::string>& names, const Names& others) {
    return std::ranges::any_of(names, [&](const std::string& name) { return others.contains(name); });
}

std::set<std::string> names_of(const ShaderModules& modules) {
    std::set<std::string> names;
    for (const auto& [name, words] : modules) names.insert(name);
    return names;
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

bool is_awaited(const LiveNews& news, const std::set<std::string>& used, const Trial& trial) {
    if (!news.errors.empty()) return false;
    return any_in(used, news.pending) || (any_in(used, news.ready) && news.tried != key_of(trial));
}

LiveShaders::LiveShaders(fs::path root, const std::vector<fs::path>& files, const std::map<std::string, float>& values,
                         std::function<void()> wake)
    : root_(std::move(root)), files_(files), tree_(tree_with(root_, files)), wake_(std::move(wake)) {
    set_.sliders = tree_.compile({}).sliders;
    slider_constants(set_.sliders, values); // throws if they are no sliders' values
    pending_ = edited_entry_points(tree_, root_, set_.sliders), reached_ = tree_.replaced();
    news_.number = 1, news_.pending = pending_, news_.tree_edited = !tree_.edited().empty();
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
        if (used == used_ && trial == trial_) return;
        trial_ = std::move(trial), used_ = std::move(used);
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
        news_.pending = pending_, news_.ready = names_of(ready_), news_.tried = tried_;
        change(news_), ++news_.number;
    }
    wake_();
}

// True once nobody waits for what is being done: the files are others by now, or the viewer ends. Asked by several threads.
std::function<bool()> LiveShaders::interruption() const {
    struct Look {
        std::mutex mutex;
        Clock::time_point next = Clock::now() + kWatchEvery;
        bool stale = false;
    };
    return [this, look = std::make_shared<Look>()] {
        if (stop_) return true;
        const std::lock_guard lock(look->mutex);
        if (!look->stale && Clock::now() >= look->next) look->stale = tree_.is_stale(), look->next = Clock::now() + kWatchEvery;
        return look->stale;
    };
}

// What to compile first is known once something has been drawn.
void LiveShaders::wait_for_a_picture() {
    std::unique_lock lock(mutex_);
    something_.wait_for(lock, kFirstPicture, [&] { return stop_ || (used_ && !used_->empty()); });
    news_.seen = Clock::now();
}

void LiveShaders::run() {
    wait_for_a_picture();
    for (bool failed = false; !stop_;) {
        try {
            if (look() || second_chance()) failed = false;
            if (!failed) failed = !step();
        } catch (const std::exception& error) { // no compiler, no room for its files
            failed = !fail({{"", 0, error.what(), ""}}) || failed;
        }
        std::unique_lock lock(mutex_);
        if (failed || !has_work()) something_.wait_for(lock, kWatchEvery, [&] { return stop_ || (!failed && has_work()); });
    }
}

// True, once after a trial failed: it is time.
bool LiveShaders::second_chance() {
    if (!second_ || Clock::now() < *second_) return false;
    second_ = Clock::time_point::max(), ends_ = ends_ || news_.sliders == SliderState::locked;
    return true;
}

// True: something changed.
bool LiveShaders::look() {
    const std::vector<std::string> changed = tree_.refresh();
    if (changed.empty()) return false;
    touched_ = changed.back(), tried_.clear(), second_.reset();
    pending_.merge(tree_.dependents(changed));
    if (std::ranges::any_of(changed, [](const std::string& name) { return name.starts_with("user/"); })) {
        pending_.merge(std::exchange(reached_, tree_.replaced())); // a function may have left the file, and its original is back
        pending_.insert(reached_.begin(), reached_.end());
    }
    const CompiledShaders texts = tree_.compile({});
    if (!same_numbers(texts.sliders, set_.sliders)) { // constants have other numbers now, in all that was ever compiled
        pending_.merge(names_of(set_.modules)), pending_.merge(names_of(ready_));
        set_.modules.clear();
    }
    set_.sliders = texts.sliders;
    for (const std::string& name : pending_) ready_.erase(name);
    publish([&](LiveNews& news) {
        news.seen = Clock::now(), news.tree_edited = !tree_.edited().empty();
        if (pending_.empty()) news.errors = texts.errors; // else they stay until it is known whether they are mended
    });
    return true;
}

// Under the mutex. The pictures use what is not compiled, or what is and was not tried with them.
bool LiveShaders::shows_untried() const {
    return used_ && (any_in(*used_, pending_) || (any_in(*used_, ready_) && tried_ != key_of(trial_)));
}

// Under the mutex, or on a copy of nothing that changes.
bool LiveShaders::has_work() const {
    return !pending_.empty() || ends_ || shows_untried();
}

// The used ones together, else ends of sliders, else some of the others. False: something is wrong with them.
bool LiveShaders::step() {
    std::set<std::string> used, others;
    Trial trial;
    bool first_shown = false;
    {
        const std::lock_guard lock(mutex_);
        trial = trial_;
        for (const std::string& name : pending_)
            if (used_ && used_->contains(name))
                used.insert(name);
            else if (others.size() < kAtOnce)
                others.insert(name);
        first_shown = used_ && any_in(*used_, ready_) && tried_ != key_of(trial_);
    }
    if (first_shown && used.empty()) publish([](LiveNews& news) { news.seen = Clock::now(); });
    bool fine = true;
    if (!used.empty() || first_shown)
        fine = show(used, trial);
    else if (ends_)
        fine = try_ends(trial);
    else if (!others.empty())
        fine = compile_others(others);
    else
        return true;
    publish([](LiveNews& news) { news.doing.clear(); });
    return fine;
}

bool LiveShaders::fail(ShaderErrors errors) {
    publish([&](LiveNews& news) { news.errors = std::move(errors), news.doing.clear(); });
    return false;
}

} // namespace lightbench::view
