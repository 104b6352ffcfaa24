// What the import found wrong (problems, which refuse the file) and what it could not express (remarks, which do not).
// In: one call a finding. Out: at most `max_problems` problems with a last line that counts the rest; every remark once.
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
    std::size_t unlisted = 0; // problems beyond max_problems
    std::vector<std::string> remarks;

    bool ok() const { return problems.empty(); }

    void problem_in(const std::string& where, unsigned line, std::string text) {
        if (problems.size() < max_problems)
            problems.push_back({where, line, 0, std::move(text)});
        else
            ++unlisted;
    }
    void problem_at(unsigned line, std::string text) { problem_in(file, line, std::move(text)); }
    void problem(std::string text) { problem_in(file, 0, std::move(text)); }

    void remark(std::string text) {
        if (std::find(remarks.begin(), remarks.end(), text) == remarks.end()) remarks.push_back(std::move(text));
    }

    void count_unlisted() {
        if (unlisted > 0) problems.push_back({file, 0, 0, fmt::format("{} further problems are not listed", unlisted)});
        unlisted = 0;
    }
};

} // namespace lightbench
