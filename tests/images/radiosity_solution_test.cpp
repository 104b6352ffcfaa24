// The file that keeps a solution of radiosity: what was written comes back bit by bit; anything else is refused with a sentence.
#include "image/file_bytes.h"
#include "render/radiosity/solution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>

namespace lightbench {
namespace {

using ::testing::HasSubstr;

class SolutionFile : public ::testing::Test {
  protected:
    SolutionFile() {
        const auto values = [](float from) { return std::vector<glm::vec3>{{from, 1e-30f, -0.0f}, {3.4e38f, from / 3, 7}}; };
        solution_.key = 0x123456789abcdef0u;
        solution_.state = {values(1), values(2), values(3), values(4), values(5), {1.0 / 3, 0, 1e-300}, 42};
    }
    void TearDown() override { std::filesystem::remove(path_); }
    std::string refusal() {
        try {
            read_solution(path_);
        } catch (const FileError& error) {
            EXPECT_EQ(error.blame, FileError::Blame::Input);
            return error.what();
        }
        return "accepted";
    }
    // Writes a good file, then what `change` made of its bytes.
    std::string refusal_of(const std::function<void(std::vector<unsigned char>&)>& change) {
        write_solution(path_, solution_);
        std::vector<unsigned char> bytes = read_file(path_);
        change(bytes);
        write_file(path_, bytes);
        return refusal();
    }
    std::string path_ = (std::filesystem::path(::testing::TempDir()) / fmt::format("solution_test_{}.lbrad", ::getpid())).string();
    RadiositySolution solution_;
};

bool same_bits(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec3)) == 0;
}

TEST_F(SolutionFile, ComesBackBitByBit) {
    write_solution(path_, solution_);
    const RadiositySolution read = read_solution(path_);
    EXPECT_EQ(read.key, solution_.key);
    EXPECT_EQ(read.state.shots, 42u);
    EXPECT_EQ(read.state.escaped, solution_.state.escaped);
    EXPECT_TRUE(same_bits(read.state.radiosity, solution_.state.radiosity) && same_bits(read.state.unshot, solution_.state.unshot) &&
                same_bits(read.state.received, solution_.state.received) &&
                same_bits(read.state.unshot_carry, solution_.state.unshot_carry) &&
                same_bits(read.state.received_carry, solution_.state.received_carry));
}

TEST_F(SolutionFile, AnyChangedByteIsFound) {
    write_solution(path_, solution_);
    const std::size_t size = read_file(path_).size();
    for (std::size_t at = 8; at < size; at += 7)
        EXPECT_THAT(refusal_of([&](auto& bytes) { bytes[at] ^= 0x10; }), HasSubstr("is truncated or was changed")) << at;
}

TEST_F(SolutionFile, ATruncatedOneIsRefused) {
    for (const std::size_t keep : {std::size_t{0}, std::size_t{7}, std::size_t{40}, std::size_t{100}})
        EXPECT_NE(refusal_of([&](auto& bytes) { bytes.resize(std::min(keep, bytes.size())); }), "accepted") << keep;
}

TEST_F(SolutionFile, OtherFilesAndOtherVersionsAreTold) {
    EXPECT_THAT(refusal_of([](auto& bytes) { bytes[0] = 'P'; }), HasSubstr("is no solution of radiosity"));
    EXPECT_THAT(refusal_of([](auto& bytes) { bytes[7] = '9'; }), HasSubstr("another version"));
}

TEST_F(SolutionFile, ANumberOfElementsThatCannotBeIsRefused) {
    EXPECT_THAT(refusal_of([](auto& bytes) { std::memset(bytes.data() + 24, 0xff, 8); }), HasSubstr("is truncated or was changed"));
}

} // namespace
} // namespace lightbench
