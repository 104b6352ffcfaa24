// Shaders that are edited while the viewer runs. In: the folder of their sources, files of the user's own, what the viewer shows at the moment.
// Out: entry points that compiled and survived a first frame in a child process, or errors where they were made. On a thread of its own.
#pragma once

#include "app/view/trial.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace lightbench::view {

// Ends of a slider may hang what its first value does not: they are tried aside, too, before a hand may go there.
enum class SliderState { trying, free, locked };

struct LiveNews {
    std::uint64_t number = 0;                     // grows with each news
    std::shared_ptr<const ShaderSet> good{};      // the last that compiled and was tried; null: the program's own
    std::set<std::string> changed{};              // entry points of it that are new
    std::chrono::steady_clock::time_point seen{}; // when the change of their sources was, or they were shown first
    ShaderErrors errors{};                        // of the last save
    std::string doing{};                          // for people: "compiling shaders"
    bool tree_edited = false;                     // files of the folder are not what the program was built from
    SliderState sliders = SliderState::trying;
    std::string locked{};                     // why
    std::map<std::string, float> values{};    // of sliders, with which `good` was tried: they hold until the sliders are free
    std::set<std::string> pending{}, ready{}; // entry points to be compiled; compiled, and tried once a picture uses them
    std::string tried{};                      // key_of() the pictures that were
};

// Constants of the set's sliders: values of that name as far as they lie in the slider's range, else its first one.
gpu::Constants constants_of(const ShaderSet& set, const std::map<std::string, float>& values);

// What the device has used is not yet what the files say, but is going to be.
bool is_awaited(const LiveNews& news, const std::set<std::string>& used, const Trial& trial);

class LiveShaders {
  public:
    // `wake` is called from its thread whenever there is news. Throws UserError for files that cannot be read and values that no slider can have.
    LiveShaders(std::filesystem::path root, const std::vector<std::filesystem::path>& files, const std::map<std::string, float>& values,
                std::function<void()> wake);
    ~LiveShaders(); // ends what is being tried

    // What the viewer shows: first pictures of it are tried. Entry points that its device has used are compiled before the others.
    void tell(Trial trial, std::shared_ptr<const std::set<std::string>> used);
    LiveNews news() const;

  private:
    void run();
    void wait_for_a_picture();
    bool look();
    bool shows_untried() const;
    bool has_work() const;
    bool step();
    bool show(const std::set<std::string>& names, const Trial& trial);
    bool try_ready(TrialRun& run);
    bool try_ends(const Trial& trial);
    bool compile_others(const std::set<std::string>& names);
    bool fail(ShaderErrors errors);
    bool fail_for_now(const std::string& problem);
    bool second_chance();
    ShaderError blamed(std::string text) const;
    std::function<bool()> interruption() const;
    void publish(const std::function<void(LiveNews&)>& change);

    std::filesystem::path root_;
    std::vector<std::filesystem::path> files_;
    ShaderTree tree_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable something_;
    Trial trial_;
    std::shared_ptr<const std::set<std::string>> used_;
    LiveNews news_;
    std::atomic<bool> stop_ = false;
    // Of its thread:
    ShaderSet set_;                                               // the next good one
    ShaderModules ready_;                                         // compiled, not tried yet: nothing that is shown uses them
    std::set<std::string> pending_;                               // entry points whose sources changed since they were compiled
    std::set<std::string> reached_;                               // by replacements, when last looked
    std::string touched_;                                         // the file that changed last
    std::string tried_;                                           // pictures that were, since the last change
    bool ends_ = false;                                           // of sliders are to be tried
    std::optional<std::chrono::steady_clock::time_point> second_; // chance of a trial that failed since the last change
    std::thread thread_;                                          // the last: it uses all of the above
};

} // namespace lightbench::view
