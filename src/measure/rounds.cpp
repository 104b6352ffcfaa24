#include "measure/rounds.h"

#include "measure/statistics.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

// False if it was stopped: the round is as if it had not been.
bool run_round(std::vector<Timed>& timed, const std::function<double(std::size_t)>& run, bool net, const std::function<bool()>& stop) {
    std::vector<double> round;
    for (std::size_t i = 0; i < timed.size(); ++i) {
        round.push_back(run(i));
        if (stop && stop()) return false;
    }
    for (std::size_t i = 0; i < timed.size(); ++i) timed[i].milliseconds.push_back(round[i] - (net && i > 0 ? round[0] : 0));
    return true;
}

// Runs that are looked at often enough are sure by luck some time. The k-th look spends 2^-k of the 5 % by which it may be wrong, so that all
// together spend no more (Wald 1947, "Sequential analysis", is the subject; this is Bonferroni's bound).
void look_at(std::vector<Timed>& timed, const RoundLimits& limits, unsigned look) {
    const double confidence = 1 - 0.05 * std::exp2(-double(look));
    for (std::size_t i = 0; i < timed.size(); ++i)
        timed[i].settled = (limits.net && i == 0) || is_settled(timed[i].milliseconds, limits.share, confidence);
}

} // namespace

std::vector<Timed> time_in_rounds(std::size_t variants, const std::function<double(std::size_t)>& run, const std::function<double()>& wall,
                                  const RoundLimits& limits, const std::function<bool()>& stop) {
    std::vector<Timed> timed(variants);
    const double start = wall();
    unsigned look = 0, next = kFirstLook;
    for (unsigned round = 1;; ++round) {
        const bool stopped = !run_round(timed, run, limits.net, stop);
        const bool last = stopped || round >= limits.most || wall() - start >= limits.milliseconds;
        if (!last && round < next) continue;
        next = round + round / 2;
        look_at(timed, limits, ++look);
        if (last || std::ranges::all_of(timed, &Timed::settled)) break;
    }
    return timed;
}

} // namespace lightbench
