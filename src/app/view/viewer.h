// The viewer itself: one window, one worker, and what passes between them.
#pragma once

#include "app/options.h"
#include "app/stats.h"
#include "app/view/interface.h"
#include "app/view/presenter.h"
#include "app/view/window.h"

#include <fstream>

namespace lightbench::view {

struct ViewOptions {
    SceneOptions scene;
    std::filesystem::path screenshots = ".";
    std::string log; // file, or empty
    bool vsync = true;
};

// Its lines tell what happened, in their order: for tests, and for people who script the viewer.
class Log {
  public:
    explicit Log(const std::string& file);
    template <class... Args> void say(fmt::format_string<Args...> text, Args&&... args) {
        if (out_.is_open()) out_ << fmt::format(text, std::forward<Args>(args)...) << std::endl;
    }

  private:
    std::ofstream out_;
};

struct Interface { // the interface's context
    Interface();
    ~Interface();
};

// Members are destroyed from the last to the first: the worker wakes the window.
class Viewer {
  public:
    Viewer(const ViewOptions& options, Opened opened, gpu::Device device);
    // Until it is closed.
    void run();
    // Shuts the device and what shows it; throws gpu::EnvironmentError if the validation layers of either had anything to say.
    void close();

  private:
    using Clock = std::chrono::steady_clock;
    void step(const Input& input);
    void note_block(double milliseconds);
    double patience() const;
    void take_input(const Input& input);
    void take_scene(ReadScene read);
    void take_news();
    void watch_shaders();
    void take_shaders();
    void tell_swap();
    Swap shaders() const;
    Trial trial() const;
    bool awaits_shaders() const;
    void say(std::string line, std::string more = "");
    std::vector<std::string> shader_words() const;
    std::vector<std::string> run_words() const;
    void fly();
    void fit_size();
    void act(Action action);
    void ask_for_pictures();
    void inspect(glm::uvec2 pixel);
    std::shared_ptr<const Answer> answer() const;
    void do_pending();
    void save_screenshot();
    void draw();
    std::vector<Placement> placements(const PictureArea& area) const;
    void show_picture(unsigned slot, const std::shared_ptr<const Image8>& picture);
    void camera_moved();
    std::string command(unsigned side) const;
    std::vector<std::string> render_words(unsigned side) const;
    bool moving() const { return Clock::now() - moved_ < std::chrono::milliseconds(150); }
    bool settled() const { return !news_.busy && !moving() && size_ == wanted_size_ && !awaits_shaders(); }

    const ViewOptions& options_;
    Log log_;
    Opened opened_;
    State state_;
    Window window_;
    Interface interface_;
    std::optional<Worker> worker_;
    std::optional<Presenter> presenter_;
    SceneFile file_;
    std::optional<LiveShaders> live_; // none: there are no sources of shaders
    LiveNews live_news_{};
    std::shared_ptr<const ShaderSet> told_swap_{};
    News news_{};
    Wish wished_{};
    std::array<std::shared_ptr<const Image8>, 2> on_screen_{};
    std::vector<std::string> problems_, recent_;
    Message message_{};
    glm::uvec2 size_{0}, wanted_size_{0}; // of the picture; the wanted one is taken once the window rests
    Clock::time_point sized_{}, moved_{}, flown_{};
    std::uint64_t told_ = 0;                               // of News::settled
    std::uint64_t frames_ = 0;                             // of the window
    double longest_block_ = 0;                             // milliseconds
    bool first_ = true, shown_ = true, minimized_ = false; // shown: the last frame
    Stopwatch since_start_{};
};

} // namespace lightbench::view
