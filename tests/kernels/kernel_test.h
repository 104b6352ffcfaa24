// The fixture of kernel tests: a device with validation switched on, whose every message fails the test.
#pragma once

#include "verdict.h"

#include <gtest/gtest.h>
#include <limits>

namespace lightbench::kernels {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kFloatMax = std::numeric_limits<float>::max();
constexpr std::size_t kMillion = 1u << 20; // random tuples for each seed

// The i-th float of a result.
inline Measure component(std::size_t i) {
    return [=](std::span<const float>, std::span<const float> out) { return static_cast<double>(out[i]); };
}

class Kernel : public testing::Test {
  protected:
    void TearDown() override { EXPECT_EQ(device.validation_messages(), std::vector<std::string>{}); }
    gpu::Device device = gpu::Device::open({.choice = "", .validation = true});
};

} // namespace lightbench::kernels
