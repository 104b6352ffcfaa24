// A screen of its own for a test, a window manager on it, the viewer in a window, and hands: real input of the X server.
#pragma once

#include "support/files.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <sys/types.h>
#include <vector>

namespace lightbench::viewer {

// Ends when it goes away.
class Process {
  public:
    Process() = default;
    Process(const std::vector<std::string>& words, const std::vector<std::pair<std::string, std::string>>& environment,
            const std::filesystem::path& out);
    Process(Process&& other) noexcept;
    Process& operator=(Process&& other) noexcept;
    ~Process();
    bool running();
    int wait(double seconds); // exit code; 128 + signal; -1: still running
    void signal(int number) const;
    void stop();

  private:
    pid_t pid_ = 0;
    int code_ = -1;
};

class Viewer : public ::testing::Test {
  protected:
    void SetUp() override; // skips where the tools are missing
    void TearDown() override;

    void start(const std::vector<std::string>& options, const std::string& scene, bool validation = true);
    void launch(const std::vector<std::string>& options, const std::string& scene, bool validation = true); // and wait for nothing
    void stop_manager() { manager_.stop(); }
    int terminate(); // as a system does that shuts down; the exit code
    // xdotool WORDS on that screen; what it prints.
    std::string tool(const std::string& words) const;
    void key(const std::string& name) const; // as xdotool calls it
    // Waits for a line of the log that begins so, after what was waited for before; the rest of the line. Fails after `seconds`.
    std::string expect(const std::string& begin, double seconds = 30);
    void forget(); // what is in the log by now
    int quit();    // Esc; the exit code
    std::string log() const;
    std::string errors() const;
    std::filesystem::path folder;
    std::string window;  // its number
    std::string display; // ":7"

  private:
    Process server_, manager_;
    Process program_;
    std::size_t read_ = 0;
};

std::string output_of(const std::string& command);

} // namespace lightbench::viewer
