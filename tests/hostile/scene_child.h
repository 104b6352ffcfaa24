// Loads a scene in a child process, so that a crash, a hang or a flood of memory is seen and measured. In: what to load. Out: how it ended.
#pragma once

#include "scene/load.h"

#include <filesystem>
#include <functional>
#include <string>

namespace lightbench::hostile {

struct Outcome {
    bool ended = false;    // by itself, without a signal and within the time
    bool accepted = false; // a scene came back
    double cpu_seconds = 0;
    double megabytes = 0; // peak of the child beyond what it began with
    std::string report;   // its problems, one a line
};

Outcome load_in_child(const std::function<Loaded()>& load);
Outcome load_in_child(const std::filesystem::path& file);

// Sanitizers make everything larger and slower; the bounds below are for plain builds.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr double kSlack = 8;
#else
inline constexpr double kSlack = 1;
#endif
inline constexpr double kMaxSeconds = 1 * kSlack, kMaxMegabytes = 256 * kSlack;

// Refused with a problem that says `reason`, within the bounds.
void expect_refused(const Outcome& outcome, const std::string& reason);

} // namespace lightbench::hostile
