// The cache file: what was written is read, and what was damaged, cut, lengthened or written for another driver is not.
#include "gpu/pipeline_cache.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace lightbench::gpu {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

class GpuPipelineCache : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "lightbench-cache-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
        for (unsigned i = 0; i < 1000; ++i) bytes.push_back(static_cast<std::byte>(i * 7));
    }
    void TearDown() override { fs::remove_all(folder); }

    std::string written() {
        CacheFile file = cache_file(folder / "deep" / "er", owner);
        write_cache(file, bytes);
        return file.path.string();
    }
    std::vector<std::byte> read(std::string* said = nullptr) {
        CacheFile file = cache_file(folder / "deep" / "er", owner);
        CaptureStderr();
        auto result = read_cache(file);
        const std::string text = GetCapturedStderr();
        if (said) *said = text;
        return result;
    }
    void expect_refused(const char* why) {
        std::string said;
        EXPECT_TRUE(read(&said).empty());
        EXPECT_THAT(said, HasSubstr(why));
    }
    static void change(const std::string& path, std::streamoff at, char mask) {
        std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
        file.seekg(at);
        const char c = static_cast<char>(file.get() ^ mask);
        file.seekp(at);
        file.put(c);
    }

    fs::path folder;
    CacheOwner owner{1, 2, 3, {4, 5}, {6, 7}};
    std::vector<std::byte> bytes;
};

TEST_F(GpuPipelineCache, RoundTripLeavesOneFile) {
    const fs::path path = written();
    std::string said;
    EXPECT_EQ(read(&said), bytes);
    EXPECT_EQ(said, "");
    EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), fs::directory_iterator()), 1) << "nothing beside it";
}

TEST_F(GpuPipelineCache, NoFileIsNoFault) {
    std::string said;
    EXPECT_TRUE(read(&said).empty());
    EXPECT_EQ(said, "");
}

TEST_F(GpuPipelineCache, EveryCutIsRefused) {
    const std::string path = written();
    for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{71}, std::size_t{72}, std::size_t{73}, std::size_t{1071}}) {
        written();
        fs::resize_file(path, size);
        expect_refused("cut short");
    }
    fs::resize_file(path, 2000);
    expect_refused("cut short");
}

TEST_F(GpuPipelineCache, EveryFlippedByteIsRefused) {
    const std::string path = written();
    const auto size = static_cast<std::streamoff>(fs::file_size(path));
    ASSERT_EQ(size, 1072);
    for (std::streamoff at = 0; at < size; ++at) {
        if (at >= 52 && at < 56) continue; // reserved
        change(path, at, 0x10);
        EXPECT_TRUE(read().empty()) << "byte " << at;
        change(path, at, 0x10);
    }
    EXPECT_EQ(read(), bytes) << "and all flips undone, it is good again";
}

TEST_F(GpuPipelineCache, ForeignFilesAreRefused) {
    const fs::path path = written();
    CacheOwner other = owner;
    other.driver_version = 4;
    fs::copy_file(path, cache_file(path.parent_path(), other).path);
    owner = other;
    expect_refused("of another device or driver");
    std::ofstream(cache_file(path.parent_path(), other).path, std::ios::binary) << std::string(500, 'x');
    expect_refused("not a cache of lightbench");
}

TEST_F(GpuPipelineCache, AFolderInItsPlaceIsNoCrash) {
    fs::create_directories(cache_file(folder / "deep" / "er", owner).path);
    EXPECT_TRUE(read().empty());
    CaptureStderr();
    written();
    EXPECT_THAT(GetCapturedStderr(), HasSubstr("cannot be written"));
}

TEST_F(GpuPipelineCache, AFolderThatCannotBeMadeIsOneWarning) {
    std::ofstream(folder / "file") << "x";
    CacheFile file = cache_file(folder / "file" / "sub", owner); // below a file: not even root can
    CaptureStderr();
    write_cache(file, bytes);
    const std::string said = GetCapturedStderr();
    EXPECT_THAT(said, HasSubstr("cannot be written"));
    EXPECT_EQ(std::ranges::count(said, '\n'), 1);
}

TEST_F(GpuPipelineCache, TheEnvironmentNamesTheFolder) {
    setenv("XDG_CACHE_HOME", "/x", 1), setenv("HOME", "/h", 1);
    unsetenv("LIGHTBENCH_CACHE_DIR"), unsetenv("LIGHTBENCH_NO_CACHE");
    EXPECT_EQ(cache_folder(), fs::path("/x/lightbench"));
    unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(cache_folder(), fs::path("/h/.cache/lightbench"));
    setenv("LIGHTBENCH_CACHE_DIR", "/c", 1);
    EXPECT_EQ(cache_folder(), fs::path("/c"));
    setenv("LIGHTBENCH_NO_CACHE", "1", 1);
    EXPECT_EQ(cache_folder(), std::nullopt);
    unsetenv("LIGHTBENCH_CACHE_DIR"), unsetenv("LIGHTBENCH_NO_CACHE");
}

} // namespace
} // namespace lightbench::gpu
