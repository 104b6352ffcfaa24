// What the header of the same name says.
#include "radiosity/patch_units.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace lightbench {
namespace {

std::vector<glm::dvec3> middles_of(const Cutting& cutting) {
    std::vector<glm::dvec3> sums(cutting.units.size(), glm::dvec3(0));
    std::vector<double> counts(cutting.units.size(), 0);
    for (const Piece& piece : cutting.pieces)
        for (std::size_t i = 0; i < piece.size(); ++i) sums[piece.unit] += cutting.points[piece.corners[i]], ++counts[piece.unit];
    for (std::size_t u = 0; u < sums.size(); ++u) sums[u] /= std::max(counts[u], 1.0);
    return sums;
}

using Pair = std::array<std::uint32_t, 2>;

// Units that share an edge which no third piece has, each pair both ways, sorted.
std::vector<Pair> neighbours_of(const Cutting& cutting) {
    struct Use {
        std::uint64_t edge;
        std::uint32_t unit;
        auto operator<=>(const Use&) const = default;
    };
    std::vector<Use> uses;
    uses.reserve(4 * cutting.pieces.size());
    for (const Piece& piece : cutting.pieces)
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const std::uint32_t a = piece.corners[i], b = piece.corners[(i + 1) % piece.size()];
            uses.push_back({(std::uint64_t{std::min(a, b)} << 32) | std::max(a, b), piece.unit});
        }
    std::sort(uses.begin(), uses.end());
    std::vector<Pair> pairs;
    for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
        while (end < uses.size() && uses[end].edge == uses[i].edge) ++end;
        if (end != i + 2 || uses[i].unit == uses[i + 1].unit) continue;
        pairs.push_back({uses[i].unit, uses[i + 1].unit});
        pairs.push_back({uses[i + 1].unit, uses[i].unit});
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

} // namespace

std::vector<std::uint32_t> gather_units(const BaseMesh& base, const Cutting& cutting, const std::vector<std::uint32_t>& groups,
                                        double patch) {
    const auto middles = middles_of(cutting);
    const auto pairs = neighbours_of(cutting);
    std::vector<std::uint32_t> patches(cutting.units.size(), kNone), found;
    const auto joins = [&](std::uint32_t u, std::uint32_t seed) {
        const std::uint32_t f = cutting.units[u].face, g = cutting.units[seed].face;
        return patches[u] == kNone && groups[f] == groups[g] && glm::distance(middles[u], middles[seed]) <= patch / 2 &&
               glm::dot(base.faces[f].normal, base.faces[g].normal) >= 0.5 * std::numbers::sqrt2;
    };
    for (std::uint32_t seed = 0; seed < patches.size(); ++seed) {
        if (patches[seed] != kNone) continue;
        patches[seed] = seed;
        found.assign(1, seed);
        for (std::size_t i = 0; i < found.size(); ++i) {
            auto pair = std::lower_bound(pairs.begin(), pairs.end(), Pair{found[i], 0});
            for (; pair != pairs.end() && (*pair)[0] == found[i]; ++pair)
                if (joins((*pair)[1], seed)) patches[(*pair)[1]] = seed, found.push_back((*pair)[1]);
        }
    }
    return patches;
}

} // namespace lightbench
