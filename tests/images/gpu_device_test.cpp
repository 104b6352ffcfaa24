// Opening devices and running out of them: choices, messages, budgets, caches; on whatever driver the tests run on.
#include "images/gpu_fixture.h"

#include <filesystem>
#include <fstream>

namespace lightbench::gpu {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class GpuDevice : public GpuTest {};

TEST_F(GpuDevice, SaysWhatItIs) {
    const DeviceInfo& info = device().info();
    EXPECT_FALSE(info.name.empty() || info.driver.empty());
    EXPECT_THAT(info.version, HasSubstr("1."));
    EXPECT_GE(info.subgroup_size, 1u);
    EXPECT_GT(info.timestamp_period, 0);
    EXPECT_GE(info.max_push_bytes, 128u);
    EXPECT_TRUE(info.sample_counts & vk::SampleCountFlagBits::e4);
    EXPECT_GT(device().memory_budget(), 0u);
    const auto list = list_devices();
    const auto found = std::ranges::find(list, info.name, [](const DeviceDescription& d) { return d.info.name; });
    ASSERT_NE(found, list.end());
    EXPECT_TRUE(found->lacks.empty());
}

TEST(GpuDeviceErrors, ChoicesThatMeanNothing) {
    EXPECT_THAT([] { Device::open({.choice = "no such thing"}); },
                throws_environment_error(AllOf(HasSubstr("matches \"no such thing\""), HasSubstr("there is 0 "))));
    EXPECT_THAT([] { Device::open({.choice = "99"}); }, throws_environment_error(HasSubstr("matches \"99\"")));
    const Environment device("LIGHTBENCH_DEVICE", "from the environment");
    EXPECT_THAT([] { Device::open(); }, throws_environment_error(HasSubstr("from the environment")));
    EXPECT_NO_THROW(Device::open({.choice = "0"})) << "what was asked for goes before the environment";
}

TEST(GpuDeviceErrors, NoDriver) {
    const Environment none("VK_DRIVER_FILES", "/nonexistent.json"), old_name("VK_ICD_FILENAMES", "/nonexistent.json");
    EXPECT_THAT([] { Device::open(); }, throws_environment_error(AllOf(HasSubstr("no Vulkan device"), HasSubstr("driver"))));
    EXPECT_TRUE(list_devices().empty());
}

TEST(GpuDeviceErrors, ValidationWithoutLayers) {
    const Environment none("VK_LAYER_PATH", "/nonexistent"), not_asked("LIGHTBENCH_VALIDATION", "0");
    EXPECT_THAT([] { Device::open({.choice = "", .validation = true}); },
                throws_environment_error(HasSubstr("VK_LAYER_KHRONOS_validation is not installed")));
    EXPECT_NO_THROW(Device::open());
    const Environment asked("LIGHTBENCH_VALIDATION", "1");
    EXPECT_THROW(Device::open(), EnvironmentError);
}

TEST_F(GpuDevice, BudgetIsHeldAndNamed) {
    const Environment small("LIGHTBENCH_MEMORY_BUDGET", "1M");
    ASSERT_EQ(device().memory_budget(), 1u << 20);
    constexpr auto kStorage = vk::BufferUsageFlagBits::eStorageBuffer;
    {
        const Buffer half = make_buffer(device(), "half", 600 << 10, kStorage);
        EXPECT_GE(device().memory_used(), 600u << 10);
        EXPECT_THAT([&] { make_buffer(device(), "other half", 600 << 10, kStorage); },
                    throws_environment_error(AllOf(HasSubstr("buffer \"other half\" needs 600.0 KiB"), HasSubstr("budget of 1.0 MiB"))));
        EXPECT_THAT(
            [&] {
                make_image(device(), "picture", {512, 512}, vk::Format::eR32G32B32A32Sfloat, vk::ImageUsageFlagBits::eStorage);
            },
            throws_environment_error(HasSubstr("image \"picture\" needs 4.0 MiB")));
    }
    EXPECT_EQ(device().memory_used(), 0u);
    EXPECT_NO_THROW(make_buffer(device(), "other half", 600 << 10, kStorage));
    EXPECT_GE(device().memory_peak(), 600u << 10);
    EXPECT_LT(device().memory_peak(), 1u << 20);
}

TEST_F(GpuDevice, ImagesThatItCannotHave) {
    EXPECT_THAT(
        [&] {
            make_image(device(), "wide", {1u << 20, 1}, vk::Format::eR8Unorm, vk::ImageUsageFlagBits::eSampled);
        },
        throws_environment_error(AllOf(HasSubstr("image \"wide\" (1048576x1"), HasSubstr("pixels a side"))));
    EXPECT_THAT(
        [&] {
            make_image(device(), "odd", {4, 4}, vk::Format::eR32G32B32A32Sfloat, vk::ImageUsageFlagBits::eColorAttachment, 32);
        },
        throws_environment_error(AllOf(HasSubstr("image \"odd\""), HasSubstr("sample count"))));
    EXPECT_EQ(device().memory_used(), 0u);
}

TEST_F(GpuDevice, TexelBuffersUpToTheLimit) {
    const std::uint64_t most = device().info().max_texel_elements * 16;
    EXPECT_TRUE(device().fits_texel_buffer(most));
    EXPECT_FALSE(device().fits_texel_buffer(most + 16));
    EXPECT_TRUE(make_texel_buffer(device(), "small", 1600).as_texel());
    // On lavapipe the limit is its whole heap, on SwiftShader a mebibyte.
    if (most + 16 < device().memory_budget()) {
        EXPECT_FALSE(make_texel_buffer(device(), "large", most + 16).as_texel());
    }
}

TEST_F(GpuDevice, UploadsAndDownloadsParts) {
    Buffer buffer = make_buffer(device(), "numbers", 400, vk::BufferUsageFlagBits::eStorageBuffer);
    std::vector<std::uint32_t> numbers(100);
    std::iota(numbers.begin(), numbers.end(), 0u);
    upload(device(), buffer, std::as_bytes(std::span(numbers)));
    const std::uint32_t patch[] = {1000, 1001};
    upload(device(), buffer, std::as_bytes(std::span(patch)), 40);
    numbers[10] = 1000, numbers[11] = 1001;
    EXPECT_EQ(download_all<std::uint32_t>(device(), buffer), numbers);
    Buffer copy = make_buffer(device(), "copy", 400, vk::BufferUsageFlagBits::eStorageBuffer);
    Recorder recorder(device());
    recorder.copy(buffer, copy, 40, 36, 360);
    recorder.submit_and_wait();
    std::array<std::uint32_t, 2> tail{};
    download(device(), copy, std::as_writable_bytes(std::span(tail)), 360);
    EXPECT_EQ(tail, (std::array<std::uint32_t, 2>{9, 1000}));
}

TEST_F(GpuDevice, PipelineCacheSurvivesAndDamageDoesNotHurt) {
    std::string folder = (std::filesystem::temp_directory_path() / "lightbench-cache-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    const Environment no_cache("LIGHTBENCH_NO_CACHE", nullptr), where("LIGHTBENCH_CACHE_DIR", folder.c_str());
    auto build = [&] {
        Device d = Device::open();
        make_compute(d, test_shader("gpu_square.comp"), {}, 8);
        EXPECT_GT(d.pipeline_milliseconds(), 0);
    };
    build();
    std::filesystem::path file; // beside the modules that went into it
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().filename().string().starts_with("pipelines-")) file = entry.path();
    ASSERT_FALSE(file.empty());
    const auto first = std::filesystem::file_size(file);
    testing::internal::CaptureStderr();
    build();
    EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::Not(HasSubstr("pipeline cache"))) << "a good file is taken without a word";
    std::filesystem::resize_file(file, first - 1);
    testing::internal::CaptureStderr();
    build();
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("cut short"));
    EXPECT_GE(std::filesystem::file_size(file), first) << "and is written anew";
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace lightbench::gpu
