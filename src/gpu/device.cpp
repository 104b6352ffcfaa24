// Opens the device: loader, instance, choice, queue, allocator, budget, cache. In: a request. Out: the Device.
#include "gpu/check.h"
#include "gpu/device_choice.h"
#include "gpu/device_state.h"

#include <cstdlib>

namespace lightbench::gpu {

void rethrow(const vk::SystemError& error, std::string_view doing) {
    switch (static_cast<vk::Result>(error.code().value())) {
    case vk::Result::eErrorDeviceLost: throw EnvironmentError(fmt::format("the Vulkan device was lost while {}", doing));
    case vk::Result::eErrorOutOfDeviceMemory: throw EnvironmentError(fmt::format("the Vulkan device ran out of memory while {}", doing));
    case vk::Result::eErrorOutOfHostMemory: throw EnvironmentError(fmt::format("the system ran out of memory while {}", doing));
    default: throw EnvironmentError(fmt::format("the Vulkan driver failed while {}: {}", doing, error.what()));
    }
}

void throw_unless_success(VkResult result, std::string_view doing) {
    guarded(doing, [&] { vk::resultCheck(static_cast<vk::Result>(result), "VulkanMemoryAllocator"); });
}

void set_name(const DeviceState& device, vk::ObjectType type, std::uint64_t handle, const std::string& name) {
    if (!device.names) return;
    device.device.setDebugUtilsObjectNameEXT({.objectType = type, .objectHandle = handle, .pObjectName = name.c_str()});
}

namespace {

vk::raii::Context open_loader() {
    try {
        return {};
    } catch (const std::runtime_error&) {
        throw EnvironmentError("no Vulkan loader: libvulkan.so.1 is not installed (Debian: libvulkan1)");
    }
}

bool has_instance_extension(const vk::raii::Context& context, std::string_view name) {
    for (const vk::ExtensionProperties& extension : context.enumerateInstanceExtensionProperties())
        if (std::string_view(extension.extensionName) == name) return true;
    return false;
}

vk::raii::Instance make_instance(const vk::raii::Context& context, bool names, bool validation) {
    std::vector<const char*> extensions, layers;
    if (names) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (validation) extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    if (validation) layers.push_back(kValidationLayer);
    const vk::ValidationFeatureEnableEXT synchronization = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    const vk::ValidationFeaturesEXT features{.enabledValidationFeatureCount = 1, .pEnabledValidationFeatures = &synchronization};
    const vk::ApplicationInfo application{.pApplicationName = "lightbench", .apiVersion = VK_API_VERSION_1_3};
    return {context, vk::InstanceCreateInfo{.pNext = validation ? &features : nullptr,
                                            .pApplicationInfo = &application,
                                            .enabledLayerCount = static_cast<std::uint32_t>(layers.size()),
                                            .ppEnabledLayerNames = layers.data(),
                                            .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                            .ppEnabledExtensionNames = extensions.data()}};
}

// The loader answers "incompatible driver" or "initialization failed" where there is no driver at all: that is an empty list.
std::vector<vk::raii::PhysicalDevice> enumerate(const vk::raii::Instance& instance) {
    try {
        return vk::raii::PhysicalDevices(instance);
    } catch (const vk::InitializationFailedError&) {
        return {};
    }
}

// What we require (device_choice.cpp), and of the rest what is there and harmless: 32-bit indices, a run a sample, unlike targets,
// doubles in measurements.
vk::raii::Device make_device(const vk::raii::PhysicalDevice& physical, std::uint32_t family) {
    const vk::PhysicalDeviceFeatures has = physical.getFeatures();
    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue{.queueFamilyIndex = family, .queueCount = 1, .pQueuePriorities = &priority};
    vk::PhysicalDeviceVulkan13Features features13{.synchronization2 = true, .dynamicRendering = true, .maintenance4 = true};
    vk::PhysicalDeviceVulkan12Features features12{.pNext = &features13, .scalarBlockLayout = true};
    const vk::PhysicalDeviceFeatures2 features{.pNext = &features12,
                                               .features = {.fullDrawIndexUint32 = has.fullDrawIndexUint32,
                                                            .independentBlend = has.independentBlend,
                                                            .sampleRateShading = has.sampleRateShading,
                                                            .fragmentStoresAndAtomics = true,
                                                            .shaderFloat64 = has.shaderFloat64}};
    return {physical, vk::DeviceCreateInfo{.pNext = &features, .queueCreateInfoCount = 1, .pQueueCreateInfos = &queue}};
}

std::unique_ptr<VmaAllocator_T, AllocatorDelete> make_allocator(const DeviceState& s) {
    VmaVulkanFunctions functions{};
    functions.vkGetInstanceProcAddr = s.context.getDispatcher()->vkGetInstanceProcAddr;
    functions.vkGetDeviceProcAddr = s.device.getDispatcher()->vkGetDeviceProcAddr;
    VmaAllocatorCreateInfo info{};
    info.vulkanApiVersion = VK_API_VERSION_1_3;
    info.instance = *s.instance;
    info.physicalDevice = *s.physical;
    info.device = *s.device;
    info.pVulkanFunctions = &functions;
    VmaAllocator allocator = nullptr;
    throw_unless_success(vmaCreateAllocator(&info, &allocator), "making the memory allocator");
    return std::unique_ptr<VmaAllocator_T, AllocatorDelete>(allocator);
}

CacheOwner owner_of(const vk::raii::PhysicalDevice& physical) {
    const auto chain = physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceVulkan11Properties>();
    const vk::PhysicalDeviceProperties& p = chain.get<vk::PhysicalDeviceProperties2>().properties;
    return {p.vendorID, p.deviceID, p.driverVersion, p.pipelineCacheUUID, chain.get<vk::PhysicalDeviceVulkan11Properties>().driverUUID};
}

void open_cache(DeviceState& s) {
    std::vector<std::byte> bytes;
    if (const auto folder = cache_folder()) {
        s.cache_file = cache_file(*folder, owner_of(s.physical));
        bytes = read_cache(*s.cache_file);
    }
    s.cache = {s.device, vk::PipelineCacheCreateInfo{.initialDataSize = bytes.size(), .pInitialData = bytes.data()}};
}

// A cache that cannot be kept costs time, nothing else.
void save_cache(DeviceState& s) noexcept {
    try {
        if (!s.cache_file || s.pipeline_milliseconds == 0) return;
        const std::vector<std::uint8_t> bytes = s.cache.getData();
        write_cache(*s.cache_file, std::as_bytes(std::span(bytes)));
    } catch (const std::exception& error) {
        std::fputs(fmt::format("pipeline cache: {}\n", error.what()).c_str(), stderr);
    }
}

void open_instance(DeviceState& s, bool validation) {
    if (validation) require_validation_layer(s.context);
    s.names = has_instance_extension(s.context, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    s.instance = make_instance(s.context, s.names, validation);
    if (validation) s.messenger = {s.instance, messenger_info(*s.log)};
}

void choose_device(DeviceState& s, std::string choice) {
    if (const char* text = std::getenv("LIGHTBENCH_DEVICE"); choice.empty() && text) choice = text;
    std::vector<vk::raii::PhysicalDevice> devices = enumerate(s.instance);
    std::vector<Candidate> candidates;
    for (const vk::raii::PhysicalDevice& device : devices) candidates.push_back(describe(device));
    const std::size_t chosen = choose(candidates, choice);
    s.info = candidates[chosen].description.info;
    s.physical = std::move(devices[chosen]);
}

void open_device(DeviceState& s) {
    s.family = queue_family(s.physical).value();
    s.device = make_device(s.physical, s.family);
    s.queue = {s.device, s.family, 0};
    s.allocator = make_allocator(s);
    s.ledger.budget = memory_budget(s.info.heap_bytes, s.info.is_cpu);
    using Mode = vk::SamplerAddressMode;
    s.nearest = {s.device, vk::SamplerCreateInfo{
                               .addressModeU = Mode::eClampToEdge, .addressModeV = Mode::eClampToEdge, .addressModeW = Mode::eClampToEdge}};
    set_name(s, *s.nearest, "nearest");
    open_cache(s);
}

} // namespace

std::vector<DeviceDescription> list_devices() {
    std::vector<DeviceDescription> list;
    try {
        DeviceState s(open_loader());
        open_instance(s, false);
        for (const vk::raii::PhysicalDevice& device : enumerate(s.instance)) list.push_back(describe(device).description);
    } catch (const EnvironmentError&) { // no loader
    } catch (const vk::IncompatibleDriverError&) {
    }
    return list;
}

Device Device::open(const DeviceRequest& request) {
    auto s = std::make_unique<DeviceState>(open_loader());
    try {
        open_instance(*s, wants_validation(request));
    } catch (const vk::IncompatibleDriverError&) {
        choose({}, request.choice);
    }
    guarded("opening the device", [&] {
        choose_device(*s, request.choice);
        open_device(*s);
    });
    return Device(std::move(s));
}

Device::Device(std::unique_ptr<DeviceState> state) : state_(std::move(state)) {}
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;

Device::~Device() {
    if (state_) save_cache(*state_);
}

const DeviceInfo& Device::info() const {
    return state_->info;
}
std::vector<std::string> Device::validation_messages() const {
    return messages_of(*state_->log);
}
std::shared_ptr<const ValidationLog> Device::validation_log() const {
    return state_->log;
}
std::uint64_t Device::memory_budget() const {
    return state_->ledger.budget;
}
std::uint64_t Device::memory_used() const {
    return state_->ledger.used;
}
std::uint64_t Device::memory_peak() const {
    return state_->ledger.peak;
}
double Device::pipeline_milliseconds() const {
    return state_->pipeline_milliseconds;
}
bool Device::fits_texel_buffer(std::uint64_t bytes) const {
    return bytes / 16 <= state_->info.max_texel_elements;
}

// Stages are known by where their words lie, and the old ones go.
void Device::replace_shaders(std::map<std::string, std::vector<std::uint32_t>, std::less<>> modules, const Constants& constants) {
    state_->stages.clear();
    state_->replaced = std::move(modules), state_->replaced_constants = constants;
}

std::set<std::string> Device::used_shaders() const {
    return state_->used;
}

} // namespace lightbench::gpu
