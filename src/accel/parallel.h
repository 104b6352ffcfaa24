// Independent pieces of work spread over threads. In: their number and what each does. What they write must not overlap.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace lightbench {

// Runs work(0) ... work(count - 1), each once, on `threads` threads (0: one a core).
template <typename Work> void run_parallel(std::size_t count, unsigned threads, const Work& work) {
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    std::atomic<std::size_t> next{0};
    const auto drain = [&] {
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i) others.emplace_back(drain);
    drain();
}

} // namespace lightbench
