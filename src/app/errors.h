// How a sub-command ends early: by the user's input. (By the environment: gpu::EnvironmentError, FileError. By a bug: CHECK.)
#pragma once

#include "scene/problem.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace lightbench {

// Exit code 2; every line is printed to standard error.
struct UserError : std::runtime_error {
    std::vector<std::string> lines;
    explicit UserError(std::vector<std::string> all) : std::runtime_error("problems of the user's input"), lines(std::move(all)) {}
    explicit UserError(const Problems& problems) : UserError(std::vector<std::string>()) {
        for (const Problem& problem : problems) lines.push_back(to_string(problem));
    }
    UserError(std::string where, std::string text) : UserError(Problems{{std::move(where), 0, 0, std::move(text)}}) {}
};

} // namespace lightbench
