// The rows of bounds run on a device: what `lightbench numerics` prints. In: rows, how many inputs. Out: a finding for every claim.
#pragma once

#include "measure/numerics/rows.h"

namespace lightbench::kernels {

constexpr std::size_t kUsualInputs = 1u << 16, kQuickInputs = 1u << 11; // random tuples a row; a few rows take more, or fewer

struct Finding {
    std::string function, file, what, domain, bound; // as in Row and Claim
    std::size_t inputs = 0;
    Verdict verdict;
};

std::vector<Finding> run_rows(gpu::Device& device, const Rows& rows, std::size_t count);

// Rows whose function or file contains the text.
Rows rows_about(std::string_view text);

} // namespace lightbench::kernels
