// device.cpp switches the feature on wherever it is there.
#include "gpu/float64.h"

#include "gpu/device_state.h"

namespace lightbench::gpu {

bool has_float64(const Device& device) {
    return device.state().physical.getFeatures().shaderFloat64 == VK_TRUE;
}

} // namespace lightbench::gpu
