// The formulas of shaders/lib/naive are for teaching: nothing includes them but each other and the pairs that measure them.
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

namespace lightbench {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool may_include(const std::string& file) {
    return file.starts_with("lib/naive/") || file.starts_with("numerics/pairs/");
}

} // namespace

TEST(NaiveShaders, AreIncludedByPairsAlone) {
    const fs::path shaders = fs::path(LIGHTBENCH_SOURCE) / "shaders";
    std::size_t including = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(shaders)) {
        if (!entry.is_regular_file() || text_of(entry.path()).find("lib/naive/") == std::string::npos) continue;
        const std::string name = entry.path().lexically_relative(shaders).generic_string();
        EXPECT_TRUE(may_include(name)) << name;
        ++including;
    }
    EXPECT_GT(including, 6u);
}

// Each tells its source and where it breaks.
TEST(NaiveShaders, SayWhereTheyBreak) {
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(LIGHTBENCH_SOURCE) / "shaders/lib/naive")) {
        if (entry.path().filename() == "real.glsl") continue;
        EXPECT_THAT(text_of(entry.path()), testing::AllOf(testing::HasSubstr("// Breaks: "), testing::ContainsRegex("1[0-9][0-9][0-9]")))
            << entry.path();
    }
}

} // namespace lightbench
