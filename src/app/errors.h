// How a sub-command ends early: by the user's input. (By the environment: gpu::EnvironmentError, FileError. By a bug: CHECK.)
#pragma once

#include "scene/problem.h"

#include <stdexcept>
#include <string>

namespace lightbench {

// Exit code 2; every problem is printed on a line of its own.
struct UserError : std::runtime_error {
    Problems problems;
    explicit UserError(Problems all) : std::runtime_error("problems of the user's input"), problems(std::move(all)) {}
    UserError(std::string where, std::string text) : UserError(Problems{{std::move(where), 0, 0, std::move(text)}}) {}
};

} // namespace lightbench
