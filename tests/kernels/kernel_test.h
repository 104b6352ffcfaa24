// The fixture of kernel tests: a device with validation switched on, whose every message fails the test.
#pragma once

#include "verdict.h"

#include <gtest/gtest.h>
#include <limits>

namespace lightbench::kernels {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kFloatMax = std::numeric_limits<float>::max();
constexpr std::size_t kMillion = 1u << 20; // random tuples for each seed

class Kernel : public testing::Test {
  protected:
    void TearDown() override { EXPECT_EQ(device.validation_messages(), std::vector<std::string>{}); }
    gpu::Device device = gpu::Device::open({.choice = "", .validation = true});
};

} // namespace lightbench::kernels
