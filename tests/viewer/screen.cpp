#include "screen.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace lightbench::viewer {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

void nap(int milliseconds = 20) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

bool has(const char* program) {
    return std::system(fmt::format("command -v {} >/dev/null 2>&1", program).c_str()) == 0;
}

} // namespace

std::string output_of(const std::string& command) {
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return "";
    std::string text;
    for (int c; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
    pclose(pipe);
    return text;
}

Process::Process(const std::vector<std::string>& words, const std::vector<std::pair<std::string, std::string>>& environment,
                 const fs::path& out) {
    pid_ = fork();
    if (pid_ != 0) return;
    const int file = open(out.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    dup2(file, 1), dup2(file, 2);
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

Process::Process(Process&& other) noexcept : pid_(std::exchange(other.pid_, 0)), code_(other.code_) {}

Process& Process::operator=(Process&& other) noexcept {
    stop();
    pid_ = std::exchange(other.pid_, 0), code_ = other.code_;
    return *this;
}

Process::~Process() {
    stop();
}

int Process::wait(double seconds) {
    for (const auto start = Clock::now(); pid_ > 0;) {
        int status = 0;
        if (waitpid(pid_, &status, WNOHANG) == pid_) {
            pid_ = 0, code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
            break;
        }
        if (std::chrono::duration<double>(Clock::now() - start).count() >= seconds) return -1;
        nap();
    }
    return code_;
}

void Process::signal(int number) const {
    if (pid_ > 0) kill(pid_, number);
}

bool Process::running() {
    return pid_ > 0 && wait(0) == -1 && pid_ > 0;
}

void Process::stop() {
    if (pid_ <= 0) return;
    kill(pid_, SIGTERM);
    if (wait(3) != -1 || pid_ <= 0) return;
    kill(pid_, SIGKILL);
    wait(3);
}

void Viewer::SetUp() {
    for (const char* program : {"Xvfb", "xdotool", "openbox"})
        if (!has(program)) GTEST_SKIP() << program << " is not installed: the viewer is not driven here (Debian: xvfb xdotool openbox)";
    std::string name = (fs::temp_directory_path() / "lightbench-viewer-XXXXXX").string();
    folder = mkdtemp(name.data());
    // The server chooses a free screen and writes its number.
    server_ = Process({"sh", "-c", "exec Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3>" + (folder / "display").string()}, {},
                      folder / "server");
    for (int i = 0; i < 500 && read_text(folder / "display").find('\n') == std::string::npos; ++i) nap();
    display = ":" + read_text(folder / "display");
    display.resize(display.find_last_not_of('\n') + 1);
    manager_ = Process({"openbox", "--sm-disable"}, {{"DISPLAY", display}}, folder / "manager");
    // A window that is mapped while the manager comes up may never be told that it is visible, for which GLFW 3.3 waits without end.
    for (int i = 0; i < 500 && std::atoi(tool("get_num_desktops").c_str()) < 1; ++i) nap();
}

void Viewer::TearDown() {
    program_.stop(), manager_.stop(), server_.stop();
    if (HasFailure()) std::fprintf(stderr, "%s\n%s\n", log().c_str(), errors().c_str());
    if (!folder.empty()) fs::remove_all(folder);
}

void Viewer::launch(const std::vector<std::string>& options, const std::string& scene, bool validation) {
    std::vector<std::string> words = {LIGHTBENCH_PROGRAM,        "view",          scene,          "--log",
                                      (folder / "log").string(), "--screenshots", folder.string()};
    words.insert(words.end(), options.begin(), options.end());
    program_ = Process(
        words, {{"DISPLAY", display}, {"LIGHTBENCH_VALIDATION", validation ? "1" : "0"}, {"XDG_STATE_HOME", (folder / "state").string()}},
        folder / "errors");
    read_ = 0, window.clear();
}

void Viewer::start(const std::vector<std::string>& options, const std::string& scene, bool validation) {
    launch(options, scene, validation);
    expect("first-frame", 40);
    for (int i = 0; i < 100 && window.empty(); ++i) {
        window = tool("search --onlyvisible --name lightbench");
        window.resize(window.find_last_not_of('\n') + 1);
        nap();
    }
    tool("windowactivate --sync " + window);
}

std::string Viewer::tool(const std::string& words) const {
    return output_of("DISPLAY=" + display + " timeout 10 xdotool " + words + " 2>>" + (folder / "xdotool").string());
}

void Viewer::key(const std::string& name) const {
    tool("key " + name);
}

std::string Viewer::expect(const std::string& begin, double seconds) {
    for (const auto start = Clock::now(); std::chrono::duration<double>(Clock::now() - start).count() < seconds; nap()) {
        const std::string text = log();
        for (std::size_t at = read_; at < text.size();) {
            const std::size_t end = text.find('\n', at);
            if (end == std::string::npos) break;
            const std::string line = text.substr(at, end - at);
            at = end + 1;
            if (!line.starts_with(begin)) continue;
            read_ = at;
            return line.substr(begin.size());
        }
        if (!program_.running()) break;
    }
    ADD_FAILURE() << "nothing in the log begins with \"" << begin << "\"";
    return "";
}

void Viewer::forget() {
    read_ = log().size();
}

int Viewer::quit() {
    key("Escape");
    return program_.wait(20);
}

int Viewer::terminate() {
    program_.signal(SIGTERM);
    return program_.wait(20);
}

std::string Viewer::log() const {
    return read_text(folder / "log");
}

std::string Viewer::errors() const {
    return read_text(folder / "errors");
}

} // namespace lightbench::viewer
