// Ctrl-C while a picture is being made: asks for an early end instead of ending the process. A second one ends it at once.
#pragma once

#include <csignal>

namespace lightbench {

constexpr int kInterrupted = 130; // exit code: 128 + SIGINT, as shells have it

// Listens for SIGINT as long as it lives; one at a time. A process that was told to ignore it (nohup, a shell's background job) goes on
// to ignore it.
class Interrupt {
  public:
    Interrupt();
    Interrupt(const Interrupt&) = delete;
    ~Interrupt();
    static bool came();

  private:
    struct sigaction before_ {};
};

} // namespace lightbench
