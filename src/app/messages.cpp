#include "app/messages.h"

#include <fmt/format.h>
#include <unistd.h>

namespace lightbench {

void Messages::say(const std::string& text) const {
    if (!quiet) fmt::print(stderr, "{}\n", text);
}

// By itself where somebody watches: a terminal, and not quiet. "always" is stronger than quiet, for whoever asks for both.
bool Messages::shows_progress() const {
    const bool watched = !quiet && isatty(STDERR_FILENO) == 1;
    return progress == Progress::always || (progress == Progress::automatic && watched);
}

void Messages::step(const std::string& text) const {
    if (shows_progress()) fmt::print(stderr, "... {}\n", text);
}

void Messages::bar(double share, int& shown) const {
    constexpr int kCells = 40;
    const bool terminal = isatty(STDERR_FILENO) == 1;
    const int percent = static_cast<int>(share * 100), due = terminal ? 1 : 10;
    if (!shows_progress() || (shown >= 0 && percent / due == shown / due)) return;
    shown = percent;
    if (!terminal) return fmt::print(stderr, "... {} %\n", percent);
    fmt::print(stderr, "\r[{:<{}}] {:3} %", std::string(static_cast<std::size_t>(share * kCells), '#'), kCells, percent);
    std::fflush(stderr);
}

void Messages::clear_bar(int& shown) const {
    if (shown >= 0 && isatty(STDERR_FILENO) == 1) fmt::print(stderr, "\r\033[K");
    shown = -1;
}

void Messages::fallbacks(const Plan& plan) const {
    for (const Line& line : plan.fallbacks) say(fmt::format("note: {}: {}", line.name, line.reason));
}

} // namespace lightbench
