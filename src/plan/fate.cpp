#include "plan/fate.h"

#include "plan/radiosity.h"

#include <fmt/format.h>

namespace lightbench {

Decision decide_effect(const Effect& effect, const Facts& facts, const Request& request) {
    const Verdict verdict = effect.wanted(facts, request);
    if (!verdict.wanted) return {Fate::skipped, verdict.reason};
    if (request.method == Method::radiosity)
        if (std::string why = left_out_by_radiosity(effect.name, facts, request.radiosity); !why.empty())
            return {Fate::skipped, std::move(why)};
    if (effect.bit == 0 && (effect.ray_bit == 0 || request.method != Method::raytrace))
        return {Fate::replaced, fmt::format("{}: {}; the rasteriser knows no rays", verdict.reason, effect.instead)};
    return {Fate::drawn, verdict.reason};
}

Method method_for(const Facts& facts, const Request& request) {
    const bool in_vain = request.method == Method::radiosity && !radiosity_verdict(facts, request.radiosity).wanted;
    return in_vain ? Method::raster : request.method;
}

} // namespace lightbench
