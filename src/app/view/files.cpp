#include "app/view/files.h"

#include "app/errors.h"
#include "image/file_bytes.h"
#include "scene/check.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <utility>

namespace lightbench::view {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds kBetweenLooks(250);
constexpr std::size_t kRemembered = 10;

ReadScene read(const fs::path& file, bool allow_outside, const Request& request) {
    ReadScene out{file, std::nullopt, {}};
    try {
        LoadOptions options;
        options.allow_outside = allow_outside;
        Loaded loaded = load_scene(file, options);
        if (loaded.scene)
            out.opened = open_scene(file, std::move(*loaded.scene), request, 0);
        else
            out.problems = problem_lines(loaded, file);
    } catch (const UserError& error) {
        out.problems = error.lines;
    } catch (const std::exception& error) {
        out.problems = {error.what()};
    }
    return out;
}

std::optional<fs::file_time_type> time_of(const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    return error ? std::nullopt : std::optional(time);
}

fs::path recent_list() {
    if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state == '/') return fs::path(state) / "lightbench/recent";
    const char* home = std::getenv("HOME");
    return home ? fs::path(home) / ".local/state/lightbench/recent" : fs::path();
}

} // namespace

SceneFile::~SceneFile() {
    if (reading_.valid()) reading_.wait();
}

void SceneFile::open(fs::path file) {
    file_ = std::move(file);
    again_ = reading_.valid(); // the window does not wait for it
    if (!again_) start();
}

void SceneFile::start() {
    reading_ = std::async(std::launch::async, read, file_, allow_outside_, request_);
}

void SceneFile::watch_files(const fs::path& file, const Scene* scene) {
    file_ = file;
    Times times;
    const auto add = [&](const fs::path& path) {
        if (const auto time = time_of(path)) times[path] = *time;
    };
    add(file);
    if (scene != nullptr)
        for (const Picture& picture : scene->pictures)
            if (picture.encoded.empty()) add(picture.file);
    if (scene == nullptr) // the pictures of the scene before stay watched
        for (const auto& [path, time] : times_) add(path);
    times_ = std::move(times);
}

void SceneFile::watch() {
    const auto now = std::chrono::steady_clock::now();
    if (reading_.valid() || now - looked_ < kBetweenLooks) return;
    looked_ = now;
    const bool changed = std::ranges::any_of(times_, [](const auto& entry) {
        const auto time = time_of(entry.first); // a file that is away is about to be replaced: it counts once it is back
        return time && *time != entry.second;
    });
    if (changed) open(file_);
}

std::optional<ReadScene> SceneFile::taken() {
    if (!reading_.valid() || reading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
    std::optional<ReadScene> out = reading_.get();
    if (!std::exchange(again_, false)) return out;
    start();
    return std::nullopt; // nobody wants that any more
}

std::vector<std::string> recent_files() {
    std::vector<std::string> files;
    std::ifstream list(recent_list());
    for (std::string line; files.size() < kRemembered && std::getline(list, line);)
        if (!line.empty()) files.push_back(line);
    return files;
}

void remember_file(const fs::path& file) {
    const fs::path list = recent_list();
    if (list.empty()) return;
    std::error_code error;
    const std::string name = fs::absolute(file, error).string();
    std::string text = name + "\n";
    std::size_t kept = 1;
    for (const std::string& other : recent_files())
        if (other != name && ++kept <= kRemembered) text += other + "\n";
    fs::create_directories(list.parent_path(), error);
    try {
        write_file(list.string(), text);
    } catch (const FileError&) { // a list that cannot be kept costs a few keystrokes
    }
}

} // namespace lightbench::view
