// What the environment did to us: no device, no memory, device lost. One sentence; the program ends with exit code 3.
#pragma once

#include <stdexcept>

namespace lightbench::gpu {

struct EnvironmentError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace lightbench::gpu
