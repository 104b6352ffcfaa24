#include "app/interrupt.h"

#include <atomic>

namespace lightbench {
namespace {

std::atomic<int> g_came = 0; // a handler can reach nothing else
static_assert(std::atomic<int>::is_always_lock_free);

void note(int signal) {
    g_came = signal;
}

} // namespace

Interrupt::Interrupt(std::vector<int> signals) {
    g_came = 0;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int signal : signals) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
        before_.emplace_back(signal, before);
    }
}

Interrupt::~Interrupt() {
    for (const auto& [signal, before] : before_) sigaction(signal, &before, nullptr);
}

bool Interrupt::came() {
    return g_came != 0;
}

int Interrupt::signal() {
    return g_came;
}

} // namespace lightbench
