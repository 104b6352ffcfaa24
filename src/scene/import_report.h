// What the import found wrong (problems, which refuse the file) and what it could not express (remarks, which do not).
// In: one call a finding. Out: at most `max_problems` of each, every remark once, and a last line that counts the rest.
#pragma once

#include "scene/problem.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace lightbench {

struct Report {
    std::string file; // as problems name it
    std::size_t max_problems = 100;
    Problems problems;
    std::size_t unlisted = 0, unlisted_remarks = 0; // beyond max_problems
    std::vector<std::string> remarks;

    bool ok() const { return problems.empty() && unlisted == 0; }

    void problem_in(const std::string& where, unsigned line, std::string text) {
        if (!problems.empty() && problems.back().file == where && problems.back().line == line && problems.back().text == text) return;
        if (problems.size() < max_problems)
            problems.push_back({where, line, 0, std::move(text)});
        else
            ++unlisted;
    }
    void problem_at(unsigned line, std::string text) { problem_in(file, line, std::move(text)); }
    void problem(std::string text) { problem_in(file, 0, std::move(text)); }

    void remark(std::string text) {
        if (std::find(remarks.begin(), remarks.end(), text) != remarks.end()) return;
        if (remarks.size() < max_problems)
            remarks.push_back(std::move(text));
        else
            ++unlisted_remarks;
    }

    void count_unlisted() {
        if (unlisted > 0) problems.push_back({file, 0, 0, fmt::format("{} further problems are not listed", unlisted)});
        if (unlisted_remarks > 0) remarks.push_back(fmt::format("{} further remarks are not listed", unlisted_remarks));
        unlisted = unlisted_remarks = 0;
    }
};

} // namespace lightbench
