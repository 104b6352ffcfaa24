// Specialises with SPIRV-Tools' passes, chosen one by one: its "-O" keeps dead bindings, unrolls and rearranges floating point.
#include "gpu/specialize.h"

#include "gpu/check.h"

#include <spirv-tools/optimizer.hpp>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace lightbench::gpu {
namespace {

// Conditional constant propagation folds what is constant (never a floating-point rearrangement, as the general simplification does);
// the branches that it decides go.
void register_branch_folding(spvtools::Optimizer& optimizer) {
    optimizer.RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateCFGCleanupPass())
        .RegisterPass(spvtools::CreateBlockMergePass());
}

// Freezing makes plain constants. Branches are folded before inlining, since a function that returns early cannot be inlined and most
// early returns depend on constants; the others are merged. Then structs fall into their members, so that a member that nobody reads
// takes what computes it along, and values reach the branches that arguments had hidden.
void register_folding(spvtools::Optimizer& optimizer) {
    optimizer.RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
        .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass());
    register_branch_folding(optimizer);
    optimizer
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass()) // those that only dead branches called, before they are inlined
        .RegisterPass(spvtools::CreateMergeReturnPass())
        .RegisterPass(spvtools::CreateInlineExhaustivePass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreateScalarReplacementPass())
        .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
        .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
        .RegisterPass(spvtools::CreateLocalMultiStoreElimPass());
    register_branch_folding(optimizer);
}

// Without the interface pass a binding that nobody reads would stay: SPIR-V 1.4 and later list all variables at the entry point.
void register_cleanup(spvtools::Optimizer& optimizer) {
    optimizer.RegisterPass(spvtools::CreateAggressiveDCEPass(false, false))
        .RegisterPass(spvtools::CreateRemoveUnusedInterfaceVariablesPass())
        .RegisterPass(spvtools::CreateDeadVariableEliminationPass())
        .RegisterPass(spvtools::CreateEliminateDeadConstantPass());
}

// The build has validated the module, with the same tools.
std::vector<std::uint32_t> run(spvtools::Optimizer& optimizer, std::span<const std::uint32_t> in, std::string_view name) {
    std::string fault;
    optimizer.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* text) { fault = text; });
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    std::vector<std::uint32_t> out;
    const bool done = optimizer.Run(in.data(), in.size(), &out, options);
    CHECK(done, "{}: {}", name, fault);
    return out;
}

} // namespace

std::vector<std::uint32_t> specialize(const ShaderCode& code, const Constants& constants) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
    for (const auto& [id, value] : constants) values[id] = {value};
    optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values));
    register_folding(optimizer);
    register_cleanup(optimizer);
    return run(optimizer, code.words, code.name);
}

std::vector<std::uint32_t> drop_unread_outputs(std::span<const std::uint32_t> vertex, std::span<const std::uint32_t> fragment) {
    std::unordered_set<std::uint32_t> locations, builtins; // that the fragment stage reads
    if (!fragment.empty()) {
        spvtools::Optimizer analysis(SPV_ENV_VULKAN_1_3);
        analysis.RegisterPass(spvtools::CreateAnalyzeLiveInputPass(&locations, &builtins));
        run(analysis, fragment, "a fragment stage");
    }
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    optimizer.RegisterPass(spvtools::CreateEliminateDeadOutputStoresPass(&locations, &builtins));
    register_cleanup(optimizer);
    return run(optimizer, vertex, "a vertex stage");
}

} // namespace lightbench::gpu
