// What a failed CHECK does: both values to standard error, then abort.
#include "gpu/check.h"

#include <cstdio>
#include <cstdlib>

namespace lightbench::check_detail {

void fail(const char* file, int line, const char* expression, const std::string& values, const std::string& sentence) {
    fmt::print(stderr, "{}:{}: CHECK({}) failed: {}{}{}\n", file, line, expression, values, sentence.empty() ? "" : "; ", sentence);
    std::fflush(stderr);
    std::abort();
}

} // namespace lightbench::check_detail
