// Filters as sums of shifted rows: every inner loop runs over contiguous memory.
#include "image/plane.h"

#include <algorithm>

namespace lightbench {
namespace {

// out += tap * in, over contiguous memory so that the compiler vectorises it.
void add_scaled(float* out, const float* in, float tap, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) out[i] += tap * in[i];
}

} // namespace

Plane filtered_rows(const Plane& in, std::span<const float> taps) {
    std::size_t radius = taps.size() / 2;
    Plane out(in.width, in.height);
    std::vector<float> padded(in.width + 2 * radius);
    for (unsigned y = 0; y < in.height; ++y) {
        const float* row = in.row(y);
        std::fill_n(padded.begin(), radius, row[0]);
        std::copy_n(row, in.width, padded.data() + radius);
        std::fill_n(padded.data() + radius + in.width, radius, row[in.width - 1]);
        for (std::size_t k = 0; k < taps.size(); ++k) add_scaled(out.row(y), padded.data() + k, taps[k], in.width);
    }
    return out;
}

Plane filtered_columns(const Plane& in, std::span<const float> taps) {
    auto radius = static_cast<long>(taps.size() / 2);
    Plane out(in.width, in.height);
    for (unsigned y = 0; y < in.height; ++y) {
        for (std::size_t k = 0; k < taps.size(); ++k) {
            long from = std::clamp(static_cast<long>(y) + static_cast<long>(k) - radius, 0L, static_cast<long>(in.height) - 1);
            add_scaled(out.row(y), in.row(static_cast<unsigned>(from)), taps[k], in.width);
        }
    }
    return out;
}

} // namespace lightbench
