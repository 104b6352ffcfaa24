// Another program, run with a limit. In: its name and arguments, what it reads. Out: what it wrote, how it ended.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lightbench {

struct ChildResult {
    int code = -1;          // exit code; 128 + the signal, if one ended it; -1: it could not be started
    bool timed_out = false; // and was killed
    bool stopped = false;   // likewise, because it was not wanted any more
    std::string out, err;   // up to 16 MiB each
    bool started() const { return code != -1 || timed_out || stopped; }
};

// A program that was started before it is known what it has to do: it waits for its input. It and what it starts are killed when this goes away.
class Child {
  public:
    // Found on PATH if `arguments[0]` has no slash; no shell. Should it outlive us all the same, it gets the processor's time of `limit`.
    Child(const std::vector<std::string>& arguments, std::chrono::milliseconds limit);
    Child(Child&& other) noexcept;
    ~Child();
    // Once. It is killed when the limit is over, or soon after `stop` (asked many times a second) is true.
    ChildResult finish(const std::string& in, std::chrono::milliseconds limit, const std::function<bool()>& stop = {});

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// Both at once. The child dies with the thread that calls this, however that ends.
ChildResult run_child(const std::vector<std::string>& arguments, const std::string& in, std::chrono::milliseconds limit,
                      const std::function<bool()>& stop = {});

} // namespace lightbench
