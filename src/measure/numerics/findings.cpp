// One run of its kernel a row, judged by every claim.
#include "measure/numerics/findings.h"

namespace lightbench::kernels {

std::vector<Finding> run_rows(gpu::Device& device, const Rows& rows, std::size_t count) {
    std::vector<Finding> findings;
    for (const Row& row : rows) {
        const KernelRun run = run_row(device, row, count, 1);
        for (const Claim& claim : row.claims)
            findings.push_back({row.function, row.file, claim.what, row.domain, claim.bound, run.inputs.count(), judge(run, claim)});
    }
    return findings;
}

Rows rows_about(std::string_view text) {
    Rows rows = all_rows();
    std::erase_if(rows,
                  [=](const Row& row) { return row.function.find(text) == std::string::npos && row.file.find(text) == std::string::npos; });
    return rows;
}

} // namespace lightbench::kernels
