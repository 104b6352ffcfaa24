#include "app/view/viewer.h"

#include "app/command_line.h"
#include "app/errors.h"
#include "app/interrupt.h"
#include "app/validation.h"
#include "app/view/camera.h"
#include "app/view/panel_rows.h"
#include "gpu/validation.h"
#include "image/files.h"

#include <fmt/ranges.h>
#include <imgui.h>

namespace lightbench::view {
namespace {

constexpr Action kFlights[] = {Action::forward, Action::back, Action::left, Action::right, Action::up, Action::down};
constexpr double kSpeed = 0.6; // scene radii a second
constexpr double kTap = 0.05;  // seconds that a key counts that is let go at once

glm::dvec3 direction_of(Action action) {
    switch (action) {
    case Action::forward: return {0, 0, 1};
    case Action::back: return {0, 0, -1};
    case Action::left: return {-1, 0, 0};
    case Action::right: return {1, 0, 0};
    case Action::up: return {0, 1, 0};
    case Action::down: return {0, -1, 0};
    default: return glm::dvec3(0);
    }
}

// For scenes that are opened later: cameras and crops are of the first.
Request without_view(Request request) {
    request.camera.clear(), request.placed.reset(), request.frame.reset(), request.crop.reset();
    return request;
}

std::string free_name(const std::filesystem::path& folder) {
    for (unsigned i = 1;; ++i)
        if (const auto path = folder / fmt::format("lightbench-{:04}.png", i); !std::filesystem::exists(path)) return path.string();
}

} // namespace

Log::Log(const std::string& file) {
    if (file.empty()) return;
    out_.open(file, std::ios::trunc);
    if (!out_) throw FileError(FileError::Blame::Environment, fmt::format("{}: cannot be written", file));
}

Interface::Interface() {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
}

Interface::~Interface() {
    ImGui::DestroyContext();
}

Viewer::Viewer(const ViewOptions& options, Opened opened, gpu::Device device)
    : options_(options), log_(options.log), opened_(std::move(opened)), state_(start(options.scene.request, opened_)),
      window_(fmt::format("{} - lightbench", opened_.file.filename().string()), opened_.size, static_cast<unsigned>(kPanelWidth)),
      file_(options.scene.allow_outside, without_view(options.scene.request)) {
    state_.vsync = options.vsync;
    style_interface(window_.scale());
    presenter_.emplace(window_.handle(), device.info().name);
    state_.screen_waits = presenter_->waits_for_screen();
    worker_.emplace(std::move(device), [] { Window::wake(); });
    file_.watch_files(opened_.file, opened_.scene.get());
    remember_file(opened_.file);
    recent_ = recent_files();
    watch_shaders();
}

void Viewer::run() {
    while (!state_.quit && !window_.closing() && !Interrupt::came()) {
        const double wanted = patience();
        const Stopwatch waited;
        Input input = window_.wait(wanted);
        const double late = waited.milliseconds() - 1000 * wanted; // others had the processor
        const Stopwatch busy;
        step(input);
        note_block(std::max(late, busy.milliseconds()));
    }
    window_.hide(); // what is still being done may take a while to end
    log_.say("quit after {} frames, longest block {:.0f} ms", frames_, longest_block_);
}

// Milliseconds in which nothing that hands did was seen.
void Viewer::note_block(double milliseconds) {
    if (milliseconds > 100) log_.say("blocked {:.0f} ms", milliseconds);
    longest_block_ = std::max(longest_block_, milliseconds);
}

void Viewer::close() {
    live_.reset();
    const auto log = presenter_->validation_log();
    presenter_.reset();
    gpu::Device device = worker_->finish();
    worker_.reset();
    close_and_check(std::move(device));
    if (const std::size_t said = gpu::messages_of(*log).size(); said > 0)
        throw gpu::EnvironmentError(fmt::format("the validation layers had {} messages about the window", said));
}

// Seconds to wait for something to happen.
double Viewer::patience() const {
    if (first_ || flown_ != Clock::time_point{} || (!shown_ && !minimized_)) return 0.005;
    return moving() || size_ != wanted_size_ ? 0.02 : news_.busy || file_.reading() ? 0.1 : 0.25;
}

void Viewer::step(const Input& input) {
    take_input(input);
    file_.watch();
    if (auto read = file_.taken()) take_scene(std::move(*read));
    const glm::ivec2 framebuffer = window_.framebuffer();
    const bool minimized = framebuffer.x <= 0 || framebuffer.y <= 0;
    if (minimized != minimized_) log_.say("{}", minimized ? "minimized" : "restored");
    minimized_ = minimized;
    fly();
    take_news();
    take_shaders();
    if (!minimized) draw();
    ask_for_pictures();
    do_pending();
}

void Viewer::take_input(const Input& input) {
    for (const KeyRow* row : input.pressed) act(row->action);
    for (const auto& file : input.dropped) file_.open(file);
}

void Viewer::act(Action action) {
    if (const glm::dvec3 way = direction_of(action); way != glm::dvec3(0)) {
        view::fly(state_.camera, way * (kSpeed * kTap * radius_of(opened_.bounds)));
        log_.say("action {}:", row_of(action).help);
        return camera_moved();
    }
    const Camera before = state_.camera;
    apply(action, state_, opened_, size_.y > 0 ? double(size_.x) / size_.y : 1);
    log_.say("action {}: {}", row_of(action).help, setting_of(action, state_));
    if (!(state_.camera == before)) camera_moved();
}

// What a click showed was of the pixel that it hit.
void Viewer::camera_moved() {
    moved_ = Clock::now();
    for (Request& side : state_.sides)
        if (side.radiosity.pick) side.radiosity.pick.reset(), side.radiosity.show = Show::light;
}

void Viewer::fly() {
    glm::dvec3 way(0);
    for (const Action action : kFlights)
        if (window_.held(action)) way += direction_of(action);
    const auto now = Clock::now();
    if (way == glm::dvec3(0)) {
        flown_ = {};
        return;
    }
    const double seconds = flown_ == Clock::time_point{} ? 0 : std::min(std::chrono::duration<double>(now - flown_).count(), 0.25);
    flown_ = now;
    view::fly(state_.camera, way * (kSpeed * seconds * radius_of(opened_.bounds)));
    camera_moved();
}

// A scene that has problems leaves the one that is shown.
void Viewer::take_scene(ReadScene read) {
    problems_ = read.problems;
    const bool same_file = read.file == opened_.file;
    if (read.opened) {
        const std::uint64_t version = opened_.version + 1;
        opened_ = std::move(*read.opened), opened_.version = version;
        if (!same_file) state_.camera = opened_.camera, remember_file(read.file), recent_ = recent_files();
        window_.set_title(fmt::format("{} - lightbench", opened_.file.filename().string()));
    }
    file_.watch_files(opened_.file, problems_.empty() || !same_file ? opened_.scene.get() : nullptr);
    if (problems_.empty())
        log_.say("opened {}", read.file.string());
    else
        log_.say("problem {}", fmt::join(problems_, " | "));
}

void Viewer::take_news() {
    const auto before = news_.answer;
    news_ = worker_->news();
    if (news_.answer && news_.answer != before)
        state_.scroll = true,
        log_.say("answered {} rays {}", news_.answer->probe ? news_.answer->probe->rays.size() : 0, news_.answer->problem);
    if (first_ && news_.shots[0] && news_.shots[0]->pixels) {
        first_ = false;
        log_.say("first-frame {:.0f} ms", since_start_.milliseconds());
    }
}

// The picture is as large as its room; while the window is being resized, the last one is stretched.
void Viewer::fit_size() {
    const ImGuiIO& io = ImGui::GetIO();
    const PictureArea area = picture_area(state_, {io.DisplaySize.x, io.DisplaySize.y}, window_.scale(), std::nullopt);
    const glm::vec2 pixels = area.room * glm::vec2(io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y);
    const glm::uvec2 wanted = state_.size.value_or(glm::clamp(glm::uvec2(pixels), glm::uvec2(1), glm::uvec2(16384)));
    if (wanted != wanted_size_) wanted_size_ = wanted, sized_ = Clock::now();
    const bool rests = Clock::now() - sized_ > std::chrono::milliseconds(150);
    if (size_ == wanted || (size_.x > 0 && !rests)) return;
    size_ = wanted;
    log_.say("size {}x{}", size_.x, size_.y);
    for (Request& side : state_.sides)
        if (side.radiosity.pick) side.radiosity.pick.reset(), side.radiosity.show = Show::light;
}

void Viewer::ask_for_pictures() {
    if (size_.x == 0) return;
    Wish wish{{opened_.scene, opened_.version}, {request_of(state_, state_.split ? 0 : state_.active, size_)}, moving()};
    if (state_.split) wish.sides.push_back(request_of(state_, 1, size_));
    wish.shaders = shaders();
    wish.wireframe = state_.wireframe, wish.normals = state_.normals;
    if (!wished_.sides.empty() && wish.same_picture(wished_)) return;
    wished_ = wish;
    worker_->wish(std::move(wish));
    news_ = worker_->news();
}

// One line for the panel, and what is shown when a hand rests on it.
void Viewer::say(std::string line, std::string more) {
    message_ = {std::move(line), std::move(more)};
}

std::vector<std::string> Viewer::render_words(unsigned side) const {
    std::vector<std::string> words = options_of(request_of(state_, side, size_));
    for (const auto& more : {run_words(), shader_words()}) words.insert(words.end(), more.begin(), more.end());
    words.insert(words.begin(), {"lightbench", "render", opened_.file.string()});
    return words;
}

std::string Viewer::command(unsigned side) const {
    std::vector<std::string> words = render_words(side);
    words.push_back("-o"), words.push_back("picture.png");
    const bool edited = live_news_.tree_edited && live_news_.good;
    return (edited ? fmt::format("LIGHTBENCH_SHADERS={} ", shell_line({shader_sources(true).string()})) : "") + shell_line(words);
}

void Viewer::save_screenshot() {
    const unsigned side = state_.split ? state_.active : 0;
    if (!news_.shots[side] || !news_.shots[side]->pixels) return;
    const std::string path = free_name(options_.screenshots);
    try {
        write_png(path, *news_.shots[side]->pixels);
        say(fmt::format("saved {}", std::filesystem::path(path).filename().string()),
            path + (state_.wireframe || state_.normals ? "\nwithout the lines over it" : ""));
        log_.say("screenshot {}", path);
    } catch (const FileError& error) {
        say("the screenshot cannot be saved", error.what());
        log_.say("problem {}", error.what());
    }
}

// What was asked for, once there is a picture that is what the settings say.
void Viewer::do_pending() {
    if (state_.copy) {
        ImGui::SetClipboardText(command(state_.active).c_str());
        say("copied the command", command(state_.active));
        log_.say("copied {}", command(state_.active));
        state_.copy = false;
    }
    const bool done = settled() && news_.shots[0];
    if (done && news_.settled != told_) {
        told_ = news_.settled;
        const Shot& shot = *news_.shots[state_.split ? state_.active : 0];
        if (!news_.problem.empty()) log_.say("problem {}", news_.problem);
        log_.say("settled {:.1f} ms, {:.1f} on the device: {}", shot.milliseconds, shot.output.device_milliseconds, command(state_.active));
    }
    if (done && state_.screenshot) save_screenshot(), state_.screenshot = false;
}

} // namespace lightbench::view
