// The end of a device: what the validation layers said of it, until its very last object, makes the run a failure.
#pragma once

#include "gpu/device.h"

namespace lightbench {

// Destroys the device. Throws gpu::EnvironmentError if validation was on and had anything to say; all of it goes to standard error.
void close_and_check(gpu::Device device);

} // namespace lightbench
