// Ctrl-C while a picture is being made, a window that is told to end: asks for an early end instead of ending the process. A second signal of
// the kind ends it at once.
#pragma once

#include <csignal>
#include <utility>
#include <vector>

namespace lightbench {

constexpr int kInterrupted = 130; // exit code: 128 + SIGINT, as shells have it

// Listens for signals as long as it lives; one at a time. A process that was told to ignore it (nohup, a shell's background job) goes on
// to ignore it.
class Interrupt {
  public:
    explicit Interrupt(std::vector<int> signals = {SIGINT});
    Interrupt(const Interrupt&) = delete;
    ~Interrupt();
    static bool came();
    static int signal(); // that came; 0: none

  private:
    std::vector<std::pair<int, struct sigaction>> before_; // of each signal
};

} // namespace lightbench
