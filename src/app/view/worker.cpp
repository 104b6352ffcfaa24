#include "app/view/worker.h"

#include "app/errors.h"
#include "app/probe_tree.h"
#include "app/view/marks.h"
#include "app/view/priority.h"

#include <cmath>
#include <fmt/ranges.h>
#include <future>
#include <utility>

namespace lightbench::view {
namespace {

// Runs f; what it throws becomes a text. Nothing: it went well.
template <class F> std::string problem_of(F&& f) {
    try {
        f();
    } catch (const UserError& error) {
        return fmt::format("{}", fmt::join(error.lines, "\n"));
    } catch (const std::bad_alloc&) {
        return "not enough memory";
    } catch (const std::exception& error) {
        return error.what();
    }
    return {};
}

// The difference of each channel, eight times as large.
Image8 difference_of(const Image8& a, const Image8& b) {
    Image8 out{a.width, a.height, std::vector<std::uint8_t>(a.rgba.size(), 255)};
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        if (i % 4 != 3) out.rgba[i] = static_cast<std::uint8_t>(std::min(8 * std::abs(int(a.rgba[i]) - int(b.rgba[i])), 255));
    return out;
}

} // namespace

gpu::Device open_beside_window(const gpu::DeviceRequest& request) {
    const auto open = [&] {
        give_way(Priority::rendering);
        return gpu::Device::open(request);
    };
    return std::async(std::launch::async, open).get();
}

Worker::Worker(gpu::Device device, std::function<void()> wake) : info_(device.info()), device_(std::move(device)), wake_(std::move(wake)) {
    thread_ = std::thread([this] { run(); });
}

Worker::~Worker() {
    if (thread_.joinable()) finish();
}

gpu::Device Worker::finish() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    something_.notify_one();
    thread_.join();
    return std::move(*device_);
}

void Worker::wish(Wish wish) {
    {
        const std::lock_guard lock(mutex_);
        if (!news_.busy) since_ = std::chrono::steady_clock::now();
        next_ = std::move(wish), news_.busy = true;
    }
    something_.notify_one();
}

void Worker::ask(Question question) {
    {
        const std::lock_guard lock(mutex_);
        question_ = std::move(question);
    }
    something_.notify_one();
}

News Worker::news() const {
    const std::lock_guard lock(mutex_);
    News news = news_;
    news.pending_for = news.busy ? std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since_).count() : 0;
    return news;
}

void Worker::publish(const std::function<void(News&)>& change) {
    {
        const std::lock_guard lock(mutex_);
        change(news_);
    }
    wake_();
}

// A camera in motion lets each of its coarse pictures come to its end: they are quick, and nothing would be seen otherwise.
bool Worker::superseded(const Wish& wish) const {
    const std::lock_guard lock(mutex_);
    return stop_ || (next_ && !wish.moving && !next_->same_picture(wish));
}

void Worker::run() {
    give_way(Priority::rendering);
    stage_.emplace(*device_);
    for (;;) {
        std::optional<Wish> wish;
        std::optional<Question> question;
        {
            std::unique_lock lock(mutex_);
            something_.wait(lock, [&] { return stop_ || next_ || question_; });
            if (stop_) break;
            wish = std::exchange(next_, std::nullopt), question = std::exchange(question_, std::nullopt);
            if (wish) since_ = std::chrono::steady_clock::now();
        }
        if (question) answer(*question);
        if (wish) take(*wish);
    }
    stage_.reset();
}

// Renderers keep the pipelines that they were made with; where nothing that was ever used changes they may.
void Worker::use_shaders(const Swap& shaders) {
    if (shaders == shaders_) return;
    static const ShaderModules none;
    const ShaderModules &before = shaders_.set ? shaders_.set->modules : none, &after = shaders.set ? shaders.set->modules : none;
    const auto of = [](const ShaderModules& modules, const std::string& name) {
        const auto at = modules.find(name);
        return at == modules.end() ? std::span<const std::uint32_t>() : std::span<const std::uint32_t>(at->second);
    };
    const auto used = device_->used_shaders();
    const bool same = shaders.constants == shaders_.constants &&
                      std::ranges::all_of(used, [&](const std::string& n) { return std::ranges::equal(of(before, n), of(after, n)); });
    if (!same) stage_->clear();
    device_->replace_shaders(after, shaders.constants);
    shaders_ = shaders;
}

void Worker::take(const Wish& wish) {
    publish([](News& news) { news.doing = "rendering", news.versus.reset(); });
    const std::string problem = problem_of([&] {
        use_shaders(wish.shaders);
        for (unsigned side = 0; side < wish.sides.size(); ++side)
            if (!shoot(wish, side)) return;
        if (wish.sides.size() == 2 && !wish.moving) compare(wish);
    });
    if (!problem.empty()) stage_->clear(); // what failed half-way is not gone on with
    const auto used = std::make_shared<const std::set<std::string>>(device_->used_shaders());
    publish([&](News& news) {
        news.problem = problem, news.progress = 0, news.shaders = wish.shaders.set, news.used = used;
        if (wish.sides.size() == 1) news.shots[1].reset(), news.versus.reset();
        if (next_) return;
        news.busy = false, ++news.settled;
    });
}

// False: it is not wanted any more.
bool Worker::shoot(const Wish& wish, unsigned side) {
    const Request& request = wish.sides[side];
    const auto doing = [&](const char* text) { publish([text](News& news) { news.doing = text; }); };
    const auto show = [&](std::shared_ptr<Shot> shot) {
        if (shot->pixels && (wish.wireframe || wish.normals)) mark(*shot, *wish.scene.scene, wish.wireframe, wish.normals);
        publish([&](News& news) { news.shots[side] = std::move(shot), news.shaders = wish.shaders.set, news.problem.clear(); });
    };
    std::shared_ptr<Shot> shot;
    if (wish.moving) {
        shot = stage_->render_moving(wish.scene, request, doing);
    } else {
        RenderOptions options;
        options.stop = [&] { return superseded(wish); };
        options.progress = [&](double share) { publish([share](News& news) { news.progress = share, news.doing = "rendering"; }); };
        options.pass = [&](const RenderOutput& so_far) {
            auto pass = std::make_shared<Shot>();
            pass->request = request;
            if (so_far.pixels) pass->pixels = std::make_shared<const Image8>(*so_far.pixels);
            publish([&](News& news) { news.shots[side] = pass; });
        };
        shot = stage_->render(wish.scene, request, options, doing);
        if (!shot->whole && superseded(wish)) return false;
    }
    show(std::move(shot));
    return !superseded(wish);
}

void Worker::compare(const Wish& wish) {
    const News now = news();
    const std::shared_ptr<const Image8> a = now.shots[0]->pixels, b = now.shots[1]->pixels;
    if (!a || !b || a->width != b->width || a->height != b->height) return;
    publish([](News& news) { news.doing = "comparing the sides", news.progress = 0; });
    auto versus = std::make_shared<Versus>();
    versus->rmse = metrics(*a, *b).rmse;
    versus->difference = std::make_shared<const Image8>(difference_of(*a, *b));
    if (superseded(wish)) return;
    const FlipMap map = flip(*a, *b);
    versus->flip = mean(map), versus->flip_map = std::make_shared<const Image8>(difference_picture(map));
    publish([&](News& news) { news.versus = versus; });
}

void Worker::answer(const Question& question) {
    auto answer = std::make_shared<Answer>();
    answer->question = question;
    answer->problem = problem_of([&] { answer->probe = probe_tree(*device_, *question.scene.scene, question.request, question.pixel); });
    publish([&](News& news) { news.answer = answer; });
}

} // namespace lightbench::view
