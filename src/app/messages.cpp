#include "app/messages.h"

#include <fmt/format.h>
#include <unistd.h>

namespace lightbench {

void Messages::say(const std::string& text) const {
    if (!quiet) fmt::print(stderr, "{}\n", text);
}

// By itself where somebody watches: a terminal, and not quiet. "always" is stronger than quiet, for whoever asks for both.
void Messages::step(const std::string& text) const {
    const bool watched = !quiet && isatty(STDERR_FILENO) == 1;
    if (progress == Progress::always || (progress == Progress::automatic && watched)) fmt::print(stderr, "... {}\n", text);
}

void Messages::fallbacks(const Plan& plan) const {
    for (const Line& line : plan.fallbacks) say(fmt::format("note: {}: {}", line.name, line.reason));
}

} // namespace lightbench
