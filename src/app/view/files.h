// Scene files of the viewer: read beside the window's thread, watched, and remembered.
#pragma once

#include "app/view/state.h"
#include "scene/load.h"

#include <chrono>
#include <filesystem>
#include <future>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lightbench::view {

struct ReadScene {
    std::filesystem::path file;
    std::optional<Opened> opened;      // none: there are problems; its version is the caller's to set
    std::vector<std::string> problems; // lines
};

class SceneFile {
  public:
    SceneFile(bool allow_outside, Request request) : allow_outside_(allow_outside), request_(std::move(request)) {}
    ~SceneFile();
    // Once what is being read has been taken; the latest counts.
    void open(std::filesystem::path file);
    // Reads again if one of the files changed, half a second after the last look at most.
    void watch();
    // What was read since; once.
    std::optional<ReadScene> taken();
    bool reading() const { return reading_.valid(); }
    // The files whose changes count: that of the scene, its pictures.
    void watch_files(const std::filesystem::path& file, const Scene* scene);

  private:
    using Times = std::map<std::filesystem::path, std::filesystem::file_time_type>;
    void start();
    bool allow_outside_;
    Request request_;
    std::filesystem::path file_;
    bool again_ = false; // file_ is to be read after what is being read
    std::future<ReadScene> reading_;
    Times times_;
    std::chrono::steady_clock::time_point looked_{};
};

// The scenes opened last, the newest first; in XDG_STATE_HOME (~/.local/state). A list that cannot be kept is no error.
std::vector<std::string> recent_files();
void remember_file(const std::filesystem::path& file);

} // namespace lightbench::view
