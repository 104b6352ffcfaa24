// The rows of all topics in one list.
#include "measure/numerics/rows.h"

#include "gpu/check.h"

#include <algorithm>

namespace lightbench::kernels {

Rows all_rows() {
    Rows all;
    for (const auto topic : {phong_rows,  power_rows,    light_rows, facet_rows, fresnel_rows,     refraction_rows, vector_rows,
                             sphere_rows, triangle_rows, box_rows,   cone_rows,  torus_rows,       offset_rows,     mapping_rows,
                             noise_rows,  bump_rows,     texel_rows, color_rows, form_factor_rows, sampling_rows})
        for (Row& row : topic()) all.push_back(std::move(row));
    return all;
}

Row row_of(std::string_view function) {
    Rows all = all_rows();
    const auto found = std::ranges::find(all, function, &Row::function);
    CHECK(found != all.end(), "no row of {}", function);
    return std::move(*found);
}

KernelRun run_row(gpu::Device& device, const Row& row, std::size_t count, unsigned seed) {
    return run_kernel(device, find_kernel(row.kernel), row.inputs(count, seed), row.results, row.words);
}

} // namespace lightbench::kernels
