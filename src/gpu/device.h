// The Vulkan device: chosen, opened and owned here, with its memory budget, pipeline cache and validation log.
// In: what the user asked for. Out: a Device, a list of devices, or an EnvironmentError of one sentence.
#pragma once

#include "gpu/errors.h"
#include "gpu/float_rules.h"
#include "gpu/specialize.h"

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>
#include <vulkan/vulkan.hpp>

namespace lightbench::gpu {

struct DeviceRequest {
    std::string choice{};    // part of a name, or an index of list_devices(); empty: LIGHTBENCH_DEVICE, else hardware first, then lavapipe
    bool validation = false; // also switched on by LIGHTBENCH_VALIDATION=1
};

struct DeviceInfo {
    std::string name{};                   // "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string driver{};                 // "llvmpipe"
    std::string version{};                // Vulkan version, then the driver's own words: "1.3.230, Mesa 22.3.6 (LLVM 15.0.6)"
    bool is_cpu = false;                  // memory is the host's: all of it is mapped, nothing is staged
    std::uint32_t subgroup_size = 0;      // invocations
    double timestamp_period = 0;          // nanoseconds a tick
    std::uint64_t max_texel_elements = 0; // texels of a texel buffer
    std::uint64_t max_storage_range = 0;  // bytes of one storage binding
    std::uint32_t max_push_bytes = 0;
    std::uint32_t max_image_side = 0;     // pixels
    std::uint32_t max_group_count = 0;    // work groups along x
    std::uint32_t subpixel_bits = 0;      // the rasteriser moves a vertex to the nearest 2^-bits of a pixel
    std::uint64_t heap_bytes = 0;         // sum of the device-local heaps
    vk::SampleCountFlags sample_counts{}; // that colour and depth attachments both have
    FloatRules float_rules{};             // of every pipeline
};

// A device and what it lacks of what lightbench requires; nothing, for one that can be used.
struct DeviceDescription {
    DeviceInfo info{};
    std::vector<std::string> lacks{};
};

// In the loader's order; a device's place is its index. Empty if there is no driver or no loader.
std::vector<DeviceDescription> list_devices();

// Every message of the validation layers of severity warning and above. Outlives the device, so that what is said at its end counts.
struct ValidationLog;
std::vector<std::string> messages_of(const ValidationLog& log);

struct DeviceState;

class Device {
  public:
    // Throws EnvironmentError: no loader, no driver, no device that matches or suffices, layers asked for and absent.
    static Device open(const DeviceRequest& request = {});
    Device(Device&&) noexcept;
    Device& operator=(Device&&) noexcept;
    ~Device(); // writes the pipeline cache

    const DeviceInfo& info() const;
    std::vector<std::string> validation_messages() const; // empty without validation
    std::shared_ptr<const ValidationLog> validation_log() const;

    std::uint64_t memory_budget() const; // bytes of device memory that we allow ourselves
    std::uint64_t memory_used() const;
    std::uint64_t memory_peak() const;    // stats: memory.device_peak
    double pipeline_milliseconds() const; // stats: time.pipelines; wall time spent in making pipelines

    // In pipelines made from now on these modules, by name, take the place of the program's own. They have been held against those
    // (render/live/fits.h); `constants` are set in them alone.
    void replace_shaders(std::map<std::string, std::vector<std::uint32_t>, std::less<>> modules, const Constants& constants = {});
    std::set<std::string> used_shaders() const; // of which pipelines were made

    bool fits_texel_buffer(std::uint64_t bytes) const; // as RGBA32UI texels

    DeviceState& state() const { return *state_; } // for this room
  private:
    explicit Device(std::unique_ptr<DeviceState>);
    std::unique_ptr<DeviceState> state_;
};

} // namespace lightbench::gpu
