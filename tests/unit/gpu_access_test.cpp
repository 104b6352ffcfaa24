// The derivation of barriers, case by case: every hazard has its barrier, and what needs none has none.
#include "gpu/access.h"

#include <gtest/gtest.h>

namespace lightbench::gpu {
namespace {

using S = vk::PipelineStageFlagBits2;
using A = vk::AccessFlagBits2;
using L = vk::ImageLayout;

const Access kComputeWrite{S::eComputeShader, A::eShaderStorageWrite, true};
const Access kComputeRead{S::eComputeShader, A::eShaderStorageRead, false};
const Access kVertexRead{S::eVertexAttributeInput, A::eVertexAttributeRead, false};
const Access kCopyWrite{S::eAllTransfer, A::eTransferWrite, true};

TEST(GpuAccess, FirstUseNeedsNoBarrier) {
    History a, b;
    EXPECT_FALSE(advance(a, kComputeWrite));
    EXPECT_FALSE(advance(b, kComputeRead)) << "the host wrote it: seen by every submit";
}

TEST(GpuAccess, ReadAfterWriteOncePerReader) {
    History h;
    advance(h, kComputeWrite);
    const auto first = advance(h, kComputeRead);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->from_stages, S::eComputeShader);
    EXPECT_EQ(first->from_access, A::eShaderStorageWrite);
    EXPECT_EQ(first->to_access, A::eShaderStorageRead);
    EXPECT_FALSE(advance(h, kComputeRead)) << "it already sees the write";
    const auto other = advance(h, kVertexRead);
    ASSERT_TRUE(other) << "another stage does not";
    EXPECT_EQ(other->from_access, A::eShaderStorageWrite);
    EXPECT_EQ(other->to_stages, S::eVertexAttributeInput);
    // A pair of (stage, access) is what is visible, not every combination of what was seen.
    EXPECT_TRUE(advance(h, {S::eVertexAttributeInput | S::eComputeShader, A::eShaderStorageRead, false}));
}

TEST(GpuAccess, WriteWaitsForReadersAndForTheLastWrite) {
    History h;
    advance(h, kComputeWrite);
    advance(h, kVertexRead);
    const auto d = advance(h, kCopyWrite);
    ASSERT_TRUE(d);
    EXPECT_EQ(d->from_stages, S::eComputeShader | S::eVertexAttributeInput);
    EXPECT_EQ(d->from_access, A::eShaderStorageWrite);
    EXPECT_EQ(d->to_stages, S::eAllTransfer);
    const auto again = advance(h, kCopyWrite);
    ASSERT_TRUE(again) << "write after write";
    EXPECT_EQ(again->from_stages, S::eAllTransfer) << "and nothing older";
}

TEST(GpuAccess, WriteAfterReadAlone) {
    History h;
    advance(h, kVertexRead);
    const auto d = advance(h, kComputeWrite);
    ASSERT_TRUE(d);
    EXPECT_EQ(d->from_stages, S::eVertexAttributeInput);
    EXPECT_FALSE(d->from_access) << "reads have nothing to make available";
}

TEST(GpuAccess, AChangeOfLayoutIsAWrite) {
    History h;
    const Access target{S::eColorAttachmentOutput, A::eColorAttachmentWrite, true, L::eColorAttachmentOptimal};
    const Access sampled{S::eComputeShader, A::eShaderSampledRead, false, L::eShaderReadOnlyOptimal};
    const Access sampled_later{S::eFragmentShader, A::eShaderSampledRead, false, L::eShaderReadOnlyOptimal};
    const auto first = advance(h, target);
    ASSERT_TRUE(first) << "from undefined";
    EXPECT_EQ(first->from_layout, L::eUndefined);
    const auto second = advance(h, sampled);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->from_layout, L::eColorAttachmentOptimal);
    EXPECT_EQ(second->to_layout, L::eShaderReadOnlyOptimal);
    EXPECT_FALSE(advance(h, sampled));
    const auto third = advance(h, sampled_later);
    ASSERT_TRUE(third) << "must wait for the change of layout, which happened before the compute stage";
    EXPECT_EQ(third->from_stages, S::eComputeShader);
    const auto back = advance(h, target);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->from_stages, S::eComputeShader | S::eFragmentShader);
}

TEST(GpuAccess, UsesOfOnePassAreOne) {
    Access both = kComputeRead;
    both.merge(kComputeWrite);
    EXPECT_TRUE(both.writes);
    EXPECT_EQ(both.access, A::eShaderStorageRead | A::eShaderStorageWrite);
    Access general{S::eComputeShader, A::eShaderStorageWrite, true, L::eGeneral};
    EXPECT_DEATH(general.merge({S::eComputeShader, A::eShaderSampledRead, false, L::eShaderReadOnlyOptimal}), "two layouts");
}

} // namespace
} // namespace lightbench::gpu
