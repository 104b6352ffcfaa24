// Specialises with SPIRV-Tools' passes, chosen one by one: its "-O" keeps dead bindings, unrolls and rearranges floating point.
#include "gpu/specialize.h"

#include "gpu/check.h"

#include <spirv-tools/optimizer.hpp>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace lightbench::gpu {
namespace {

// Calls are inlined and loads forwarded, so that constants reach the branches; conditional constant propagation then folds what is
// constant (and never rearranges floating point, as the general simplification does), and branches that cannot be taken go.
void register_round(spvtools::Optimizer& optimizer) {
    optimizer.RegisterPass(spvtools::CreateInlineExhaustivePass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
        .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
        .RegisterPass(spvtools::CreateLocalMultiStoreElimPass())
        .RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateCFGCleanupPass())
        .RegisterPass(spvtools::CreateBlockMergePass());
}

// Two rounds: a function that returns early cannot be inlined until the first has removed the returns that cannot be reached. (Merging
// returns instead leaves constructs that Mesa turns into loops, and loops are budgeted there.)
void register_folding(spvtools::Optimizer& optimizer) {
    optimizer.RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
        .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass());
    register_round(optimizer);
    register_round(optimizer);
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
