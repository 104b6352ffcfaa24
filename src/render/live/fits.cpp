#include "render/live/fits.h"

#include "gpu/reflect.h"

#include <algorithm>
#include <fmt/format.h>
#include <spirv-tools/libspirv.hpp>

namespace lightbench {
namespace {

using gpu::ReflectedBinding;
using gpu::ReflectedVariable;
using gpu::Reflection;
using Sentences = std::vector<std::string>;

// The validator's first complaint; empty if there is none. Finding names for it takes four times as long as validating.
std::string invalid(std::span<const std::uint32_t> words, bool names = false) {
    std::string fault;
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* text) {
        if (fault.empty()) fault = text;
    });
    spvtools::ValidatorOptions options;
    options.SetScalarBlockLayout(true), options.SetFriendlyNames(names);
    if (tools.Validate(words.data(), words.size(), options)) return "";
    if (!names) return invalid(words, true);
    return fault.empty() ? "not SPIR-V" : fault;
}

void compare_bindings(const Reflection& own, const Reflection& edited, Sentences& out) {
    for (const ReflectedBinding& b : edited.bindings) {
        const auto known = std::ranges::find_if(own.bindings, [&](const auto& k) { return k.set == b.set && k.binding == b.binding; });
        if (known == own.bindings.end())
            out.push_back(fmt::format("binding {} of set {}, \"{}\": the program binds nothing there", b.binding, b.set, b.name));
        else if (known->kind != b.kind || known->name != b.name || known->count != b.count || known->block_size != b.block_size ||
                 known->array_stride != b.array_stride)
            out.push_back(fmt::format("binding {} of set {}, \"{}\": the program binds the {} \"{}\" there, of another layout", b.binding,
                                      b.set, b.name, to_string(known->kind), known->name));
        else if (b.written && !known->written)
            out.push_back(fmt::format("binding \"{}\" is written; the program expects it to be read only", b.name));
    }
}

void compare_variables(const char* what, const std::vector<ReflectedVariable>& own, const std::vector<ReflectedVariable>& edited, bool all,
                       Sentences& out) {
    const auto same = [](const ReflectedVariable& a) {
        return [&a](const ReflectedVariable& b) { return a.location == b.location && a.format == b.format; };
    };
    for (const ReflectedVariable& v : edited)
        if (std::ranges::none_of(own, same(v)))
            out.push_back(fmt::format("{} \"{}\" at location {}: there is none of its type", what, v.name, v.location));
    for (const ReflectedVariable& v : own)
        if (all && std::ranges::none_of(edited, same(v)))
            out.push_back(fmt::format("{} \"{}\" at location {} is missing", what, v.name, v.location));
}

} // namespace

std::vector<std::string> misfits(const gpu::ShaderCode& own, std::span<const std::uint32_t> edited) {
    if (std::string fault = invalid(edited); !fault.empty()) return {fmt::format("not valid: {}", fault)};
    const Reflection before = gpu::reflect(own.words), after = gpu::reflect(edited);
    Sentences out;
    if (before.stage != after.stage) return {"its stage is another one"};
    if (before.local_size != after.local_size)
        out.push_back(fmt::format("its work group is {} x {} x {}; the program expects {} x {} x {}", after.local_size[0],
                                  after.local_size[1], after.local_size[2], before.local_size[0], before.local_size[1],
                                  before.local_size[2]));
    if (after.push_size != 0 && after.push_size != before.push_size)
        out.push_back(fmt::format("its push constants have {} bytes; the program gives {}", after.push_size, before.push_size));
    compare_bindings(before, after, out);
    compare_variables("input", before.inputs, after.inputs, false, out);
    compare_variables("output", before.outputs, after.outputs, true, out);
    return out;
}

} // namespace lightbench
