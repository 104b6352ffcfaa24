// A device with validation for tests of the gpu room: every message of the layers, up to the device's end, fails the test.
#pragma once

#include "gpu/recorder.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <numeric>
#include <optional>

std::span<const lightbench::gpu::ShaderCode> gpu_test_shaders_table();

namespace lightbench::gpu {

inline ShaderCode test_shader(std::string_view name) {
    for (const ShaderCode& code : gpu_test_shaders_table())
        if (code.name == name) return code;
    ADD_FAILURE() << name;
    return {};
}

// Sets an environment variable for as long as it lives; null unsets it.
class Environment {
  public:
    Environment(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        set(value);
    }
    Environment(const Environment&) = delete;
    ~Environment() { set(old_ ? old_->c_str() : nullptr); }

  private:
    void set(const char* value) { value ? setenv(name_, value, 1) : unsetenv(name_); }
    const char* name_;
    std::optional<std::string> old_;
};

class GpuTest : public testing::Test {
  protected:
    void TearDown() override {
        const auto log = device_ ? device_->validation_log() : nullptr;
        device_.reset();
        if (!log) return;
        if (expects_messages) {
            EXPECT_FALSE(messages_of(*log).empty());
        } else {
            EXPECT_THAT(messages_of(*log), testing::IsEmpty());
        }
    }
    Device& device() {
        if (!device_) device_.emplace(Device::open({.choice = "", .validation = true}));
        return *device_;
    }
    bool expects_messages = false;

  private:
    Environment no_cache_{"LIGHTBENCH_NO_CACHE", "1"};
    std::optional<Device> device_;
};

inline auto throws_environment_error(const auto& matcher) {
    return testing::Throws<EnvironmentError>(testing::Property(&EnvironmentError::what, matcher));
}

} // namespace lightbench::gpu
