#include "app/interrupt.h"

#include <atomic>

namespace lightbench {
namespace {

std::atomic<bool> g_came = false; // a handler can reach nothing else
static_assert(std::atomic<bool>::is_always_lock_free);

void note(int) {
    g_came = true;
}

} // namespace

Interrupt::Interrupt() {
    g_came = false;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, nullptr, &before_);
    if (before_.sa_handler != SIG_IGN) sigaction(SIGINT, &action, nullptr);
}

Interrupt::~Interrupt() {
    sigaction(SIGINT, &before_, nullptr);
}

bool Interrupt::came() {
    return g_came;
}

} // namespace lightbench
