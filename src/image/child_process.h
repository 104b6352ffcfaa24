// Another program, run with a limit. In: its name and arguments, what it reads. Out: what it wrote, how it ended.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace lightbench {

struct ChildResult {
    int code = -1;          // exit code; 128 + the signal, if one ended it; -1: it could not be started
    bool timed_out = false; // and was killed
    std::string out, err;   // up to 16 MiB each
    bool started() const { return code != -1 || timed_out; }
};

// Found on PATH if `arguments[0]` has no slash; no shell. The child and what it starts are killed when the limit is over.
ChildResult run_child(const std::vector<std::string>& arguments, const std::string& in, std::chrono::milliseconds limit);

} // namespace lightbench
