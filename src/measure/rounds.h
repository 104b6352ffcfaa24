// Runs of several variants in turn (A B C A B C ...), so that what drifts meanwhile hits all alike, until their medians are sure enough.
#pragma once

#include <functional>
#include <vector>

namespace lightbench {

struct RoundLimits {
    unsigned most = 100;           // rounds
    double milliseconds = 240'000; // of wall time: no round begins after them
    double share = 0.05;           // of a median, that its 95 % interval keeps within
    bool net = false;              // variant 0 is an empty run: what it takes is taken off the others of its round before they are judged
};

struct Timed {
    std::vector<double> milliseconds; // a run each
    bool settled = false;
};

constexpr unsigned kFirstLook = 7; // runs; fewer do not tell how sure a median is

// `run(i)` returns the milliseconds of one run of variant i, `wall()` those since any moment. One round at least, but for `stop`: once it
// says so, the round under way is left out, and nothing begins after it.
std::vector<Timed> time_in_rounds(std::size_t variants, const std::function<double(std::size_t)>& run, const std::function<double()>& wall,
                                  const RoundLimits& limits, const std::function<bool()>& stop = {});

} // namespace lightbench
