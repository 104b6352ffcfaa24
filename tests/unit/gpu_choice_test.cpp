// Which device a choice means, the budget's arithmetic, CHECK: decisions that need no device.
#include "gpu/check.h"
#include "gpu/device_choice.h"
#include "gpu/memory_budget.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace lightbench::gpu {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Property;
using testing::Throws;
using Type = vk::PhysicalDeviceType;

Candidate candidate(const char* name, const char* driver, Type type, std::vector<std::string> lacks = {}) {
    Candidate c;
    c.description.info.name = name, c.description.info.driver = driver, c.description.lacks = std::move(lacks), c.type = type;
    return c;
}

std::vector<Candidate> four() {
    std::vector<Candidate> list{candidate("llvmpipe (LLVM 15.0.6, 256 bits)", "llvmpipe", Type::eCpu),
                                candidate("Intel UHD", "Mesa", Type::eIntegratedGpu),
                                candidate("Old Thing 9000", "legacy", Type::eDiscreteGpu, {"Vulkan 1.3", "scalarBlockLayout"}),
                                candidate("Big GPU", "vendor", Type::eDiscreteGpu)};
    list[0].aliases = "lavapipe";
    return list;
}

auto says(const char* a, const char* b) {
    return Throws<EnvironmentError>(Property(&EnvironmentError::what, AllOf(HasSubstr(a), HasSubstr(b))));
}

TEST(GpuChoice, HardwareFirstThenLavapipe) {
    EXPECT_EQ(choose(four(), ""), 3u) << "the discrete one that lacks nothing";
    EXPECT_EQ(choose({four()[0], four()[1]}, ""), 1u);
    EXPECT_EQ(choose({four()[0], four()[2]}, ""), 0u) << "not the one that lacks something";
}

TEST(GpuChoice, ByNameDriverAliasOrIndex) {
    EXPECT_EQ(choose(four(), "intel"), 1u);
    EXPECT_EQ(choose(four(), "LLVM"), 0u);
    EXPECT_EQ(choose(four(), "lavapipe"), 0u);
    EXPECT_EQ(choose(four(), "vendor"), 3u);
    EXPECT_EQ(choose(four(), "1"), 1u);
    EXPECT_THAT([] { choose(four(), "4"); }, says("no Vulkan device matches \"4\"", "3 Big GPU"));
    EXPECT_THAT([] { choose(four(), "geforce"); }, says("no Vulkan device matches \"geforce\"", "0 llvmpipe"));
}

TEST(GpuChoice, SaysWhatIsLacking) {
    EXPECT_THAT([] { choose(four(), "2"); }, says("Old Thing 9000", "lacks Vulkan 1.3, scalarBlockLayout"));
    EXPECT_THAT([] { choose({}, ""); }, says("no Vulkan device", "driver"));
}

TEST(GpuBudget, Sizes) {
    EXPECT_EQ(parse_bytes("65536"), 65536u);
    EXPECT_EQ(parse_bytes("3K"), 3072u);
    EXPECT_EQ(parse_bytes("512M"), 512u << 20);
    EXPECT_EQ(parse_bytes("2G"), std::uint64_t{2} << 30);
    for (const char* bad : {"", "M", "-1", "1.5G", "2GB", " 2", "99999999999999999999", "17179869184G"})
        EXPECT_FALSE(parse_bytes(bad)) << bad;
    EXPECT_EQ(show_bytes(1000), "1000 bytes");
    EXPECT_EQ(show_bytes(1536), "1.5 KiB");
    EXPECT_EQ(show_bytes(std::uint64_t{2} << 30), "2.0 GiB");
}

TEST(GpuBudget, LedgerNamesWhatAskedAndKeepsThePeak) {
    MemoryLedger ledger{1000};
    ledger.take(600, "buffer \"a\"");
    EXPECT_THAT([&] { ledger.take(401, "image \"depth\""); }, says("image \"depth\" needs 401 bytes", "only 400 bytes are left"));
    EXPECT_EQ(ledger.used, 600u) << "what was refused is not counted";
    ledger.take(400, "buffer \"b\"");
    ledger.give(900);
    EXPECT_EQ(ledger.used, 100u);
    EXPECT_EQ(ledger.peak, 1000u);
    EXPECT_THAT([&] { ledger.take(~std::uint64_t{0}, "everything"); }, says("everything", "left")) << "no wrap-around";
}

TEST(GpuBudget, EnvironmentLowersButNeverRaises) {
    unsetenv("LIGHTBENCH_MEMORY_BUDGET");
    EXPECT_EQ(memory_budget(1 << 20, false), 1u << 20);
    EXPECT_EQ(memory_budget(1 << 20, true), 1u << 20) << "a mebibyte is less than 60 % of any machine's memory";
    EXPECT_LT(memory_budget(std::uint64_t{1} << 60, true), std::uint64_t{1} << 60) << "of what the system has available";
    setenv("LIGHTBENCH_MEMORY_BUDGET", "64K", 1);
    EXPECT_EQ(memory_budget(1 << 20, false), 65536u);
    setenv("LIGHTBENCH_MEMORY_BUDGET", "4G", 1);
    EXPECT_EQ(memory_budget(1 << 20, false), 1u << 20);
    setenv("LIGHTBENCH_MEMORY_BUDGET", "lots", 1);
    EXPECT_THAT([] { memory_budget(1 << 20, false); }, says("LIGHTBENCH_MEMORY_BUDGET is \"lots\"", "512M"));
    unsetenv("LIGHTBENCH_MEMORY_BUDGET");
}

TEST(GpuCheck, PrintsBothValuesAndAborts) {
    const int three = 3;
    const std::string name = "x";
    CHECK(three == 3, "never read");
    CHECK(!name.empty());
    EXPECT_DEATH(CHECK(three + 1 == 5, "while counting {}", name), R"(CHECK\(three \+ 1 == 5\) failed: 4 == 5; while counting x)");
    EXPECT_DEATH(CHECK(name == std::string("y")), "x == y");
    EXPECT_DEATH(CHECK(three < 2), "3 < 2");
}

} // namespace
} // namespace lightbench::gpu
