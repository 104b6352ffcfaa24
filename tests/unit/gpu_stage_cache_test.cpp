// Kept modules: what comes from a file is what specialisation makes, whatever happened to the file.
#include "gpu/stage_cache.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

std::span<const lightbench::gpu::ShaderCode> gpu_test_shaders_table();

namespace lightbench::gpu {
namespace {

namespace fs = std::filesystem;

ShaderCode variants() {
    for (const ShaderCode& code : gpu_test_shaders_table())
        if (code.name == "gpu_variants.comp") return code;
    ADD_FAILURE();
    return {};
}

class GpuStageCache : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "lightbench-stages-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override { fs::remove_all(folder); }

    std::vector<fs::path> files() const {
        std::vector<fs::path> all;
        for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry.path());
        return all;
    }
    Words variant(std::uint32_t mask) const { return StageCache(folder).specialized(variants(), {{0, mask}}); }

    fs::path folder;
};

TEST_F(GpuStageCache, WhatIsKeptIsWhatIsMade) {
    for (const std::uint32_t mask : {0u, 1u, 2u, 3u})
        for (int time = 0; time < 2; ++time) EXPECT_EQ(variant(mask), specialize(variants(), {{0, mask}})) << mask;
    EXPECT_EQ(files().size(), 4u) << "one a variant, none beside";
}

// Nothing is written the second time.
TEST_F(GpuStageCache, AModuleComesFromItsFile) {
    ShaderCode code = variants();
    StageCache cache(folder);
    const Words words = cache.specialized(code, {{0, 1}});
    const auto written = fs::last_write_time(files().at(0));
    fs::last_write_time(files().at(0), written - std::chrono::hours(1));
    EXPECT_EQ(cache.specialized(code, {{0, 1}}), words);
    EXPECT_EQ(fs::last_write_time(files().at(0)), written - std::chrono::hours(1)) << "made and written anew";
}

TEST_F(GpuStageCache, DamageAndStrangersAreMadeAnew) {
    const Words one = variant(1);
    const fs::path file = files().at(0);
    std::fstream(file, std::ios::binary | std::ios::in | std::ios::out).seekp(200).put('\x55');
    EXPECT_EQ(variant(1), one);
    fs::resize_file(file, fs::file_size(file) / 2);
    EXPECT_EQ(variant(1), one);
    const Words two = variant(2);
    for (const fs::path& other : files())
        if (other != file) fs::copy_file(other, file, fs::copy_options::overwrite_existing);
    EXPECT_EQ(variant(1), one) << "of another variant, under this one's name";
    EXPECT_NE(one, two);
}

TEST_F(GpuStageCache, WithoutAPlaceNothingIsKept) {
    const Words one = specialize(variants(), {{0, 1}});
    EXPECT_EQ(StageCache(std::nullopt).specialized(variants(), {{0, 1}}), one);
    std::ofstream(folder / "file") << "x";
    testing::internal::CaptureStderr();
    EXPECT_EQ(StageCache(folder / "file" / "below").specialized(variants(), {{0, 1}}), one); // not even root can write there
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "the driver's cache says it, once";
}

TEST_F(GpuStageCache, TheOldestGoWhenThereAreTooMany) {
    for (int i = 0; i < 1100; ++i) std::ofstream(folder / ("stage-" + std::to_string(i) + ".bin")) << i;
    std::ofstream(folder / "pipelines-1.bin") << "the driver's";
    for (const fs::path& old : files()) fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(1));
    const Words one = variant(1);
    EXPECT_LE(files().size(), 1024u);
    EXPECT_TRUE(fs::exists(folder / "pipelines-1.bin"));
    const std::size_t before = files().size();
    EXPECT_EQ(variant(1), one);
    EXPECT_EQ(files().size(), before) << "the newest stayed";
}

} // namespace
} // namespace lightbench::gpu
