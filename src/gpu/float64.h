// Whether shaders may compute in double: devices need not, and nothing but measurements asks for it.
#pragma once

#include "gpu/device.h"

namespace lightbench::gpu {

bool has_float64(const Device& device);

} // namespace lightbench::gpu
