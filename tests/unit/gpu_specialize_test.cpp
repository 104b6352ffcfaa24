// Specialisation and reflection, on SPIR-V alone: what a constant makes dead is gone, what is left is described rightly.
#include "gpu/specialize.h"

#include "gpu/float_rules.h"
#include "gpu/reflect.h"

#include <gmock/gmock.h>
#include <spirv-tools/libspirv.hpp>

#include <chrono>

std::span<const lightbench::gpu::ShaderCode> gpu_test_shaders_table();

namespace lightbench::gpu {
namespace {

using testing::ElementsAre;

ShaderCode shader(std::string_view name) {
    for (const ShaderCode& code : gpu_test_shaders_table())
        if (code.name == name) return code;
    ADD_FAILURE() << name;
    return {};
}

std::vector<std::string> names(const Reflection& r) {
    std::vector<std::string> result;
    for (const ReflectedBinding& b : r.bindings) result.push_back(b.name);
    return result;
}

std::vector<std::uint32_t> locations(const std::vector<ReflectedVariable>& variables) {
    std::vector<std::uint32_t> result;
    for (const ReflectedVariable& v : variables) result.push_back(v.location);
    return result;
}

unsigned count_opcode(const std::vector<std::uint32_t>& words, std::uint32_t opcode) {
    unsigned count = 0;
    for (std::size_t i = 5; i < words.size(); i += std::max(words[i] >> 16, 1u)) count += (words[i] & 0xffff) == opcode;
    return count;
}

bool validates(const std::vector<std::uint32_t>& words) {
    const spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    spvtools::ValidatorOptions options;
    options.SetScalarBlockLayout(true);
    return tools.Validate(words.data(), words.size(), options);
}

// SPIR-V 1.6, sec. 3.49.
constexpr std::uint32_t kOpSpecConstantTrue = 48, kOpSpecConstant = 50, kOpFunctionCall = 57, kOpVariable = 59, kOpImageFetch = 95,
                        kOpLoopMerge = 246;

std::vector<std::uint32_t> variant(std::uint32_t mask) {
    return specialize(shader("gpu_variants.comp"), {{0, mask}});
}

TEST(GpuSpecialize, ABindingThatAConstantKillsIsGone) {
    EXPECT_THAT(names(reflect(shader("gpu_variants.comp").words)), ElementsAre("first", "Second", "target")) << "before: all of them";
    EXPECT_THAT(names(reflect(variant(3))), ElementsAre("first", "Second", "target"));
    EXPECT_THAT(names(reflect(variant(1))), ElementsAre("first", "target"));
    EXPECT_THAT(names(reflect(variant(2))), ElementsAre("Second", "target"));
    EXPECT_THAT(names(reflect(variant(0))), ElementsAre("target"));
}

TEST(GpuSpecialize, SoAreItsInstructionsAndVariables) {
    EXPECT_EQ(count_opcode(variant(1), kOpImageFetch), 1u);
    EXPECT_EQ(count_opcode(variant(1), kOpLoopMerge), 0u);
    EXPECT_EQ(count_opcode(variant(2), kOpImageFetch), 0u);
    EXPECT_EQ(count_opcode(variant(2), kOpLoopMerge), 1u) << "and the loop is not unrolled or lost";
    EXPECT_LT(count_opcode(variant(0), kOpVariable), count_opcode(variant(3), kOpVariable));
    EXPECT_LT(variant(0).size(), variant(1).size());
}

TEST(GpuSpecialize, NothingIsLeftToSpecialise) {
    for (const std::uint32_t mask : {0u, 1u, 2u, 3u}) {
        const auto words = variant(mask);
        EXPECT_EQ(count_opcode(words, kOpSpecConstant) + count_opcode(words, kOpSpecConstantTrue) + count_opcode(words, kOpFunctionCall),
                  0u);
        EXPECT_TRUE(validates(words)) << mask;
    }
}

// Constants that are not given keep their defaults (mask 3), and numbers that the module does not have are no error.
TEST(GpuSpecialize, DefaultsAndForeignConstants) {
    EXPECT_EQ(specialize(shader("gpu_variants.comp"), {}), variant(3));
    EXPECT_EQ(specialize(shader("gpu_variants.comp"), {{0, 1}, {77, 5}}), variant(1));
}

TEST(GpuSpecialize, TakesMilliseconds) {
    const auto start = std::chrono::steady_clock::now();
    for (unsigned i = 0; i < 10; ++i) variant(i & 3);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() / 10;
    RecordProperty("milliseconds", std::to_string(ms));
    EXPECT_LT(ms, 200) << "each; 2 ms on an idle machine";
}

TEST(GpuSpecialize, VertexOutputsThatNobodyReadsGoWithTheirInputs) {
    const auto vertex = specialize(shader("gpu_triangle.vert"), {}), fragment = specialize(shader("gpu_triangle.frag"), {});
    EXPECT_THAT(locations(reflect(vertex).outputs), ElementsAre(0, 1)) << "alone, a vertex stage keeps what it writes";
    const auto lean = drop_unread_outputs(vertex, fragment);
    EXPECT_THAT(locations(reflect(lean).outputs), ElementsAre(0));
    EXPECT_THAT(locations(reflect(lean).inputs), ElementsAre(0, 1));
    EXPECT_TRUE(validates(lean));
    const auto depth_only = drop_unread_outputs(vertex, {});
    EXPECT_THAT(locations(reflect(depth_only).outputs), ElementsAre());
    EXPECT_THAT(locations(reflect(depth_only).inputs), ElementsAre(0)) << "the position is still written";
    EXPECT_TRUE(validates(depth_only));
}

unsigned count_words(const std::vector<std::uint32_t>& words, std::uint32_t opcode, std::uint32_t operand, std::size_t place) {
    unsigned count = 0;
    for (std::size_t i = 5; i < words.size(); i += std::max(words[i] >> 16, 1u))
        count += (words[i] & 0xffff) == opcode && (words[i] >> 16) > place && words[i + place] == operand;
    return count;
}

// 17 OpCapability, 16 OpExecutionMode, 71 OpDecorate; 4466 and 4461 SignedZeroInfNanPreserve, 42 NoContraction.
TEST(GpuFloatRules, EveryStageKeepsNaNAndIsNotFused) {
    for (const ShaderCode& code : gpu_test_shaders_table()) {
        const auto plain = specialize(code, {}), strict = apply_float_rules(plain, {.keep_nan = true, .unfused = true});
        EXPECT_EQ(count_words(strict, 17, 4466, 1), 1u) << code.name;
        EXPECT_EQ(count_words(strict, 16, 4461, 2), 1u) << code.name;
        EXPECT_GE(count_words(strict, 71, 42, 2), count_opcode(plain, 129) + count_opcode(plain, 131) + count_opcode(plain, 133))
            << code.name << ": OpFAdd, OpFSub, OpFMul";
        EXPECT_TRUE(validates(strict)) << code.name;
        EXPECT_EQ(apply_float_rules(plain, {}), plain) << code.name;
        EXPECT_EQ(apply_float_rules(strict, {.unfused = true}), strict) << code.name << ": once is enough";
    }
}

TEST(GpuFloatRules, OutliveTheStrippingOfOutputs) {
    const auto strict = [](std::string_view name) { return apply_float_rules(specialize(shader(name), {}), {true, true}); };
    const auto lean = drop_unread_outputs(strict("gpu_triangle.vert"), strict("gpu_triangle.frag"));
    EXPECT_EQ(count_words(lean, 16, 4461, 2), 1u);
    EXPECT_TRUE(validates(lean));
}

TEST(GpuReflect, Compute) {
    const Reflection r = reflect(variant(3));
    EXPECT_EQ(r.stage, vk::ShaderStageFlagBits::eCompute);
    EXPECT_THAT(r.local_size, ElementsAre(64, 1, 1));
    EXPECT_EQ(r.push_size, 16u) << "vec3 and uint, scalar layout";
    const ReflectedBinding &first = *r.find("first"), &second = *r.find("Second"), &target = *r.find("target");
    EXPECT_EQ(first.kind, BindingKind::uniform_texel);
    EXPECT_TRUE(first.read && !first.written);
    EXPECT_EQ(second.kind, BindingKind::storage_buffer);
    EXPECT_EQ(second.binding, 1u);
    EXPECT_TRUE(second.read && !second.written);
    EXPECT_EQ(second.array_stride, 4u);
    EXPECT_EQ(target.set, 1u);
    EXPECT_EQ(target.binding, 2u);
    EXPECT_TRUE(!target.read && target.written);
    EXPECT_EQ(target.array_stride, 12u) << "scalar layout: 16 would be std430";
    EXPECT_EQ(target.block_size, 4u) << "what stands before the run-time array";
    EXPECT_EQ(r.find("second"), nullptr);
}

TEST(GpuReflect, GraphicsStages) {
    const Reflection vertex = reflect(specialize(shader("gpu_triangle.vert"), {})),
                     fragment = reflect(specialize(shader("gpu_triangle.frag"), {}));
    EXPECT_EQ(vertex.stage, vk::ShaderStageFlagBits::eVertex);
    EXPECT_EQ(vertex.inputs.at(0).format, vk::Format::eR32G32B32A32Sfloat);
    EXPECT_EQ(fragment.stage, vk::ShaderStageFlagBits::eFragment);
    EXPECT_EQ(fragment.push_size, 4u);
    EXPECT_TRUE(fragment.find("Count")->read && fragment.find("Count")->written);
    EXPECT_THAT(locations(fragment.outputs), ElementsAre(0));
}

TEST(GpuReflect, Images) {
    const Reflection r = reflect(specialize(shader("gpu_mirror.comp"), {}));
    EXPECT_EQ(r.find("picture")->kind, BindingKind::sampled_image);
    EXPECT_EQ(r.find("mirrored")->kind, BindingKind::storage_image);
    EXPECT_TRUE(r.find("mirrored")->written && !r.find("mirrored")->read);
}

} // namespace
} // namespace lightbench::gpu
