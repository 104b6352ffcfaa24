// Another program, run with a limit. In: its name and arguments, what it reads. Out: what it wrote, how it ended.
#pragma once

#include <chrono>
#include <functional>
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

// Found on PATH if `arguments[0]` has no slash; no shell. The child and what it starts are killed when the limit is over, or soon after `stop`
// (asked many times a second) is true. The child dies with the thread that calls this, however that ends.
ChildResult run_child(const std::vector<std::string>& arguments, const std::string& in, std::chrono::milliseconds limit,
                      const std::function<bool()>& stop = {});

} // namespace lightbench
