// What the import found wrong (problems, which refuse the file) and what it could not express (remarks, which do not).
// In: one call a finding. Out: at most log.max of each, every remark once, the rest counted.
#pragma once

#include "scene/problem_log.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace lightbench::importer {

struct Report {
    std::string file; // as problems name it
    ProblemLog log;
    std::vector<std::string> remarks;
    std::size_t unlisted_remarks = 0;

    bool ok() const { return log.empty(); }

    void problem_in(const std::string& where, unsigned line, std::string text) {
        const bool again =
            !log.kept.empty() && log.kept.back().file == where && log.kept.back().line == line && log.kept.back().text == text;
        if (!again) lightbench::report(log, where, line, 0, std::move(text));
    }
    void problem_at(unsigned line, std::string text) { problem_in(file, line, std::move(text)); }
    void problem(std::string text) { problem_in(file, 0, std::move(text)); }

    void remark(std::string text) {
        if (std::find(remarks.begin(), remarks.end(), text) != remarks.end()) return;
        if (remarks.size() < log.max)
            remarks.push_back(std::move(text));
        else
            ++unlisted_remarks;
    }
};

} // namespace lightbench::importer
