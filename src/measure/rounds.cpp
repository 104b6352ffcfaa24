#include "measure/rounds.h"

#include "measure/statistics.h"

#include <algorithm>

namespace lightbench {

std::vector<Timed> time_in_rounds(std::size_t variants, const std::function<double(std::size_t)>& run, const std::function<double()>& wall,
                                  const RoundLimits& limits) {
    std::vector<Timed> timed(variants);
    const double start = wall();
    for (unsigned round = 0; round == 0 || (round < limits.most && wall() - start < limits.milliseconds); ++round) {
        for (std::size_t i = 0; i < variants; ++i) timed[i].milliseconds.push_back(run(i));
        for (Timed& t : timed) t.settled = is_settled(t.milliseconds, limits.share);
        if (std::ranges::all_of(timed, &Timed::settled)) break;
    }
    return timed;
}

} // namespace lightbench
