#include "render/live/endless.h"

#include <algorithm>
#include <map>
#include <set>
#include <spirv_cross/spirv.h>
#include <vector>

namespace lightbench {
namespace {

using Words = std::span<const std::uint32_t>;
using Id = std::uint32_t;

struct Block {
    std::vector<Id> next;
    bool ends = false;  // the function or the invocation
    bool loops = false; // is the head of a loop, whose place this is:
    Id file = 0;
    unsigned line = 0;
};

struct Function {
    Id first = 0;
    std::vector<Id> order;
    std::map<Id, Block> blocks;
    std::set<Id> calls;
};

struct Module {
    std::map<Id, Function> functions;
    std::map<Id, std::string> strings;
    std::map<Id, bool> constants; // conditions
    std::set<Id> entries;
};

void read_branch(SpvOp op, Words w, const Module& module, Block& block) {
    if (op == SpvOpBranch) block.next = {w[1]};
    if (op == SpvOpSwitch)
        for (std::size_t i = 2; i < w.size(); i += 2) block.next.push_back(w[i]); // the default, then a literal before each
    if (op != SpvOpBranchConditional) return;
    const auto known = module.constants.find(w[1]);
    if (known == module.constants.end())
        block.next = {w[2], w[3]};
    else
        block.next = {known->second ? w[2] : w[3]};
}

bool ends(SpvOp op) {
    return op == SpvOpReturn || op == SpvOpReturnValue || op == SpvOpKill || op == SpvOpUnreachable || op == SpvOpTerminateInvocation;
}

struct Reader {
    Module module{};
    Function* function = nullptr;
    Block* block = nullptr;
    Id file = 0;
    unsigned line = 0;

    void read_global(SpvOp op, Words w) {
        if (op == SpvOpEntryPoint) module.entries.insert(w[2]);
        if (op == SpvOpConstantTrue || op == SpvOpConstantFalse) module.constants[w[2]] = op == SpvOpConstantTrue;
        if (op == SpvOpString) module.strings[w[1]] = reinterpret_cast<const char*>(&w[2]); // ends in a zero: the module is valid
        if (op == SpvOpFunction) function = &module.functions[w[2]], block = nullptr;
    }
    void read_code(SpvOp op, Words w) {
        if (op == SpvOpLine) file = w[1], line = w[2];
        if (op == SpvOpLabel) {
            if (function->order.empty()) function->first = w[1];
            function->order.push_back(w[1]), block = &function->blocks[w[1]];
        }
        if (block == nullptr) return;
        if (op == SpvOpFunctionCall) function->calls.insert(w[3]);
        if (op == SpvOpLoopMerge) block->loops = true, block->file = file, block->line = line;
        if (ends(op)) block->ends = true;
        read_branch(op, w, module, *block);
    }
    void read(Words words) {
        constexpr std::size_t header = 5;
        for (std::size_t at = header; at < words.size(); at += words[at] >> 16) {
            const auto op = static_cast<SpvOp>(words[at] & 0xffff);
            const Words w = words.subspan(at, words[at] >> 16);
            read_global(op, w);
            if (function != nullptr) read_code(op, w);
            if (op == SpvOpFunctionEnd) function = nullptr;
        }
    }
};

// `from` and what `next` leads to.
template <class Next> std::set<Id> reached(Id from, const Next& next) {
    std::set<Id> seen{from};
    for (std::vector<Id> open{from}; !open.empty();) {
        const Id id = open.back();
        open.pop_back();
        for (const Id other : next(id))
            if (seen.insert(other).second) open.push_back(other);
    }
    return seen;
}

const Block* endless_in(const Function& function) {
    const auto next = [&](Id id) -> const std::vector<Id>& { return function.blocks.at(id).next; };
    const std::set<Id> entered = reached(function.first, next);
    for (const Id id : function.order) {
        if (!entered.contains(id) || !function.blocks.at(id).loops) continue;
        const std::set<Id> inside = reached(id, next);
        const auto is_end = [&](Id other) { return function.blocks.at(other).ends; };
        if (std::none_of(inside.begin(), inside.end(), is_end)) return &function.blocks.at(id);
    }
    return nullptr;
}

} // namespace

std::optional<EndlessLoop> endless_loop(Words words) {
    Reader reader;
    reader.read(words);
    const Module& module = reader.module;
    for (const Id entry : module.entries)
        for (const Id id : reached(entry, [&](Id f) { return module.functions.at(f).calls; })) {
            const Function& function = module.functions.at(id);
            const Block* block = function.order.empty() ? nullptr : endless_in(function);
            if (block == nullptr) continue;
            const auto file = module.strings.find(block->file);
            return EndlessLoop{file == module.strings.end() ? "" : file->second, block->line};
        }
    return std::nullopt;
}

} // namespace lightbench
