// Instructions added to a module, word by word: SPIR-V 1.6, sec. 2.3 (instructions), 2.4 (their order in a module), 3 (numbers).
#include "gpu/float_rules.h"

#include "gpu/check.h"

#include <initializer_list>
#include <span>
#include <unordered_set>

namespace lightbench::gpu {
namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kOpExtInst = 12, kOpEntryPoint = 15, kOpExecutionMode = 16, kOpCapability = 17, kOpTypeVoid = 19, kOpTypeFloat = 22,
                        kOpTypeVector = 23, kOpTypeMatrix = 24, kOpTypeForwardPointer = 39, kOpDecorate = 71, kOpFNegate = 127,
                        kOpFAdd = 129, kOpFSub = 131, kOpFMul = 133, kOpFDiv = 136, kOpFRem = 140, kOpDot = 148;
constexpr std::uint32_t kSignedZeroInfNanPreserve = 4466, kModeSignedZeroInfNanPreserve = 4461, kNoContraction = 42;

using Words = std::vector<std::uint32_t>;

template <class F> void for_each_instruction(std::span<const std::uint32_t> words, F f) {
    for (std::size_t at = kHeaderWords; at < words.size();) {
        const std::size_t count = words[at] >> 16;
        CHECK(count > 0u, "word {}", at);
        CHECK(at + count <= words.size(), "word {}", at);
        f(words[at] & 0xffffu, words.subspan(at, count), at);
        at += count;
    }
}

void append(Words& to, std::uint32_t opcode, std::initializer_list<std::uint32_t> operands) {
    to.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | opcode);
    to.insert(to.end(), operands);
}

// From OpFRem to OpDot: remainders and products of vectors and matrices.
bool is_arithmetic(std::uint32_t opcode) {
    return opcode == kOpFNegate || opcode == kOpFAdd || opcode == kOpFSub || opcode == kOpFMul || opcode == kOpFDiv ||
           (opcode >= kOpFRem && opcode <= kOpDot);
}

// Decorations for all results of arithmetic, functions such as length() included, that have none yet.
Words without_contraction(std::span<const std::uint32_t> words) {
    std::unordered_set<std::uint32_t> floats, done;
    Words decorations;
    for_each_instruction(words, [&](std::uint32_t opcode, std::span<const std::uint32_t> in, std::size_t) {
        if (opcode == kOpDecorate && in[2] == kNoContraction) done.insert(in[1]);
        if (opcode == kOpTypeFloat) floats.insert(in[1]);
        if ((opcode == kOpTypeVector || opcode == kOpTypeMatrix) && floats.contains(in[2])) floats.insert(in[1]);
        const bool computes = is_arithmetic(opcode) || (opcode == kOpExtInst && floats.contains(in[1]));
        if (computes && !done.contains(in[2])) append(decorations, kOpDecorate, {in[2], kNoContraction});
    });
    return decorations;
}

} // namespace

// Capabilities come first, modes behind the entry point, decorations last before the types.
Words apply_float_rules(Words words, const FloatRules& rules) {
    if (rules == FloatRules{}) return words;
    const Words decorations = rules.unfused ? without_contraction(words) : Words{};
    Words out(words.begin(), words.begin() + kHeaderWords);
    if (rules.keep_nan) append(out, kOpCapability, {kSignedZeroInfNanPreserve});
    bool typed = false;
    for_each_instruction(words, [&](std::uint32_t opcode, std::span<const std::uint32_t> in, std::size_t) {
        const bool first_type = !typed && opcode >= kOpTypeVoid && opcode <= kOpTypeForwardPointer;
        if (first_type) out.insert(out.end(), decorations.begin(), decorations.end()), typed = true;
        out.insert(out.end(), in.begin(), in.end());
        if (opcode == kOpEntryPoint && rules.keep_nan) append(out, kOpExecutionMode, {in[2], kModeSignedZeroInfNanPreserve, 32});
    });
    return out;
}

} // namespace lightbench::gpu
