#include "engine/gpu/fold_constants.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/gpu/spirv.h"

namespace nacre::gpu {
namespace {

using namespace spirv;

constexpr std::uint32_t kSpecId = 1, kLocation = 30;  // decorations
constexpr std::uint32_t kVertex = 0, kFragment = 4;   // execution models
constexpr std::uint32_t kInput = 1, kOutput = 3;      // storage classes

template <typename Visit>
void forEach(Words words, const Visit& visit) {
    find(words, kHeader, [&](const Instruction& i) {
        visit(i);
        return false;
    });
}

/// The result of an operation on two booleans or integers of 32 bits; null for operations that conditions rarely have.
std::optional<std::uint32_t> evaluate(std::uint32_t operation, std::uint32_t a, std::uint32_t b) {
    const auto signedA = static_cast<std::int32_t>(a), signedB = static_cast<std::int32_t>(b);
    switch (operation) {
        case kOpLogicalEqual:
        case kOpIEqual:
            return a == b;
        case kOpLogicalNotEqual:
        case kOpINotEqual:
            return a != b;
        case kOpLogicalOr:
            return a | b;
        case kOpLogicalAnd:
            return a & b;
        case kOpUGreaterThan:
            return a > b;
        case kOpSGreaterThan:
            return signedA > signedB;
        case kOpUGreaterThanEqual:
            return a >= b;
        case kOpSGreaterThanEqual:
            return signedA >= signedB;
        case kOpULessThan:
            return a < b;
        case kOpSLessThan:
            return signedA < signedB;
        case kOpULessThanEqual:
            return a <= b;
        case kOpSLessThanEqual:
            return signedA <= signedB;
        default:
            return std::nullopt;
    }
}

/// Booleans and integers of 32 bits that are known when a pipeline is made.
class Constants {
public:
    Constants(Words words, const Specialization& given) {
        forEach(words, [&](const Instruction& i) {
            if (i.operation == kOpDecorate && i.operands.size() == 3 && i.operands[1] == kSpecId) {
                if (const std::optional<std::uint32_t> value = given.value(i.operands[2]))
                    given_[i.operands[0]] = *value;
            } else if (i.operands.size() >= 2) {
                if (const std::optional<std::uint32_t> value = valueOf(i)) values_[i.operands[1]] = *value;
            }
        });
    }
    std::optional<std::uint32_t> operator()(std::uint32_t id) const {
        const auto found = values_.find(id);
        return found == values_.end() ? std::nullopt : std::optional(found->second);
    }

private:
    std::optional<std::uint32_t> valueOf(const Instruction& i) const {
        const auto specialized = [&](std::uint32_t standard) {
            const auto found = given_.find(i.operands[1]);
            return found == given_.end() ? standard : found->second;
        };
        switch (i.operation) {
            case kOpConstantTrue:
                return 1;
            case kOpConstantFalse:
                return 0;
            case kOpSpecConstantTrue:
                return specialized(1);
            case kOpSpecConstantFalse:
                return specialized(0);
            case kOpConstant:
            case kOpSpecConstant:
                return i.operands.size() == 3 ? std::optional(specialized(i.operands[2])) : std::nullopt;
            case kOpSpecConstantOp:
                return compute(i.operands[2], i.operands.subspan(3));
            default:  // glslang also writes expressions of constants as plain instructions
                return compute(i.operation, i.operands.subspan(2));
        }
    }
    std::optional<std::uint32_t> compute(std::uint32_t operation, Words operands) const {
        const bool negates = operation == kOpLogicalNot;
        if (operands.size() != (negates ? 1 : 2)) return std::nullopt;
        const std::optional<std::uint32_t> a = (*this)(operands[0]), b = negates ? a : (*this)(operands[1]);
        if (!a || !b) return std::nullopt;
        return negates ? std::optional<std::uint32_t>(*a == 0) : evaluate(operation, *a, *b);
    }

    std::map<std::uint32_t, std::uint32_t> given_, values_;  // of ids
};

/// The result of an instruction in a function, if it has one.
std::optional<std::uint32_t> resultOf(const Instruction& i) {
    switch (i.operation) {
        case kOpLabel:
            return i.operands[0];
        case kOpStore:
        case kOpCopyMemory:
        case kOpImageWrite:
        case kOpControlBarrier:
        case kOpMemoryBarrier:
        case kOpAtomicStore:
        case kOpLoopMerge:
        case kOpSelectionMerge:
        case kOpBranchConditional:
        case kOpSwitch:
            return std::nullopt;
        default:
            return i.operands.size() < 2 || i.operation >= kOpReturnValue ? std::nullopt : std::optional(i.operands[1]);
    }
}

/// The blocks that run, and what they use.
class Reached {
public:
    explicit Reached(Words words) {
        std::uint32_t function = 0, block = 0, entry = 0;
        std::map<std::uint32_t, std::uint32_t> first;                // block of each function
        std::map<std::uint32_t, std::vector<std::uint32_t>> follow;  // blocks and functions that a block leads to
        forEach(words, [&](const Instruction& i) {
            if (i.operation == kOpEntryPoint) entry = i.operands[1];
            if (i.operation == kOpFunction) function = i.operands[1], block = 0;
            if (i.operation == kOpLabel) {
                if (block == 0) first[function] = i.operands[0];
                block = i.operands[0];
            }
            if (block != 0) addTargets(i, follow[block]);
        });
        std::vector<std::uint32_t> open{entry};
        while (!open.empty()) {
            const std::uint32_t id = open.back();
            open.pop_back();
            if (!ids_.insert(id).second) continue;
            const auto start = first.find(id);
            if (start != first.end()) open.push_back(start->second);
            open.insert(open.end(), follow[id].begin(), follow[id].end());
        }
    }
    /// @param id  of a block or a function
    bool operator()(std::uint32_t id) const { return ids_.contains(id); }

private:
    /// Blocks after a merge stay, even where none leads to them.
    static void addTargets(const Instruction& i, std::vector<std::uint32_t>& to) {
        const auto add = [&](std::size_t from, std::size_t end, std::size_t step) {
            for (; from < std::min(end, i.operands.size()); from += step) to.push_back(i.operands[from]);
        };
        if (i.operation == kOpBranch || i.operation == kOpSelectionMerge) add(0, 1, 1);
        if (i.operation == kOpLoopMerge) add(0, 2, 1);
        if (i.operation == kOpBranchConditional) add(1, 3, 1);
        if (i.operation == kOpSwitch) add(1, i.operands.size(), 2);
        if (i.operation == kOpFunctionCall) add(2, 3, 1);
    }

    std::set<std::uint32_t> ids_;
};

void copy(const Instruction& i, Words words, std::vector<std::uint32_t>& out) {
    out.insert(out.end(), words.begin() + static_cast<std::ptrdiff_t>(i.at),
               words.begin() + static_cast<std::ptrdiff_t>(i.end()));
}

/// A phi of those of its blocks that lead to it.
template <typename Leads>
void copyPhi(const Instruction& i, const Leads& leads, std::vector<std::uint32_t>& out) {
    const std::size_t at = out.size();
    out.insert(out.end(), {0, i.operands[0], i.operands[1]});
    for (std::size_t pair = 2; pair + 1 < i.operands.size(); pair += 2)
        if (leads(i.operands[pair + 1])) out.insert(out.end(), {i.operands[pair], i.operands[pair + 1]});
    out[at] = static_cast<std::uint32_t>(out.size() - at) << 16 | kOpPhi;
}

/// What a stage uses of itself.
struct Usage {
    std::vector<bool> kept;        ///< of each instruction: it is outside functions, or in a block that runs
    std::set<std::uint32_t> gone;  ///< results of the others, and variables that only they used
};

/// @returns with outputs of a vertex stage, and inputs of a fragment stage, among the variables
Usage findUsage(Words words) {
    const Reached reached(words);
    Usage usage;
    std::set<std::uint32_t> used, located;
    std::uint32_t passed = ~0u;  // storage class of variables between stages
    bool runs = true, function = true, body = false;
    forEach(words, [&](const Instruction& i) {
        if (i.operation == kOpEntryPoint && i.operands[0] == kVertex) passed = kOutput;
        if (i.operation == kOpEntryPoint && i.operands[0] == kFragment) passed = kInput;
        if (i.operation == kOpDecorate && i.operands[1] == kLocation) located.insert(i.operands[0]);
        if (i.operation == kOpFunction) runs = function = reached(i.operands[1]), body = true;
        if (i.operation == kOpLabel) runs = reached(i.operands[0]);
        if (i.operation == kOpFunctionEnd) runs = function;
        usage.kept.push_back(runs);
        if (runs && body) used.insert(i.operands.begin(), i.operands.end());
        const std::optional<std::uint32_t> result = runs ? std::nullopt : resultOf(i);
        if (result) usage.gone.insert(*result);
        if (i.operation == kOpFunctionEnd) runs = true, body = false;
    });
    forEach(words, [&](const Instruction& i) {
        if (i.operation == kOpVariable && i.operands[2] == passed && located.contains(i.operands[1]) &&
            !used.contains(i.operands[1]))
            usage.gone.insert(i.operands[1]);
    });
    return usage;
}

/// Copies an entry point without variables that are gone.
void copyEntryPoint(const Instruction& i, Words words, const Usage& usage, std::vector<std::uint32_t>& out) {
    const std::size_t at = out.size(), name = (text(i.operands, 2).size() + 4) / 4;
    copy(i, words, out);
    const auto variables = out.begin() + static_cast<std::ptrdiff_t>(at + 3 + name);
    out.erase(std::remove_if(variables, out.end(), [&](std::uint32_t id) { return usage.gone.contains(id); }),
              out.end());
    out[at] = static_cast<std::uint32_t>(out.size() - at) << 16 | kOpEntryPoint;
}

std::vector<std::uint32_t> dropUnused(Words words) {
    const Usage usage = findUsage(words);
    std::vector<std::uint32_t> out(words.begin(), words.begin() + kHeader);
    std::size_t next = 0;
    forEach(words, [&](const Instruction& i) {
        const bool refers = i.operation == kOpName || i.operation == kOpDecorate;
        if (!usage.kept[next++] || (refers && usage.gone.contains(i.operands[0]))) return;
        if (i.operation == kOpVariable && usage.gone.contains(i.operands[1])) return;
        if (i.operation == kOpPhi)
            copyPhi(
                i, [&](std::uint32_t from) { return !usage.gone.contains(from); }, out);
        else if (i.operation == kOpEntryPoint)
            copyEntryPoint(i, words, usage, out);
        else
            copy(i, words, out);
    });
    return out;
}

}  // namespace

std::vector<std::uint32_t> foldConstants(std::span<const std::uint32_t> words, const Specialization& constants) {
    const Constants known(words, constants);
    // The branch that ends a block, if its condition is known, and the edges that go with the others.
    std::map<std::size_t, std::uint32_t> taken;                 // by place of the OpSelectionMerge
    std::set<std::pair<std::uint32_t, std::uint32_t>> dropped;  // from one block to another
    std::uint32_t block = 0;
    std::optional<Instruction> merge;
    forEach(words, [&](const Instruction& i) {
        if (i.operation == kOpLabel) block = i.operands[0];
        if (i.operation == kOpBranchConditional && merge && i.operands[1] != i.operands[2])
            if (const std::optional<std::uint32_t> holds = known(i.operands[0])) {
                taken[merge->at] = i.operands[*holds != 0 ? 1 : 2];
                dropped.emplace(block, i.operands[*holds != 0 ? 2 : 1]);
            }
        merge = i.operation == kOpSelectionMerge ? std::optional(i) : std::nullopt;
    });
    if (taken.empty()) return {words.begin(), words.end()};
    std::vector<std::uint32_t> out(words.begin(), words.begin() + kHeader);
    out.reserve(words.size());
    bool replaced = false;  // the instruction before this one was
    forEach(words, [&](const Instruction& i) {
        if (i.operation == kOpLabel) block = i.operands[0];
        const auto branch = taken.find(i.at);
        if (branch != taken.end()) {
            append(out, kOpBranch, {branch->second});
            replaced = true;
        } else if (!std::exchange(replaced, false)) {
            const auto leads = [&](std::uint32_t from) { return !dropped.contains(std::pair(from, block)); };
            if (i.operation == kOpPhi)
                copyPhi(i, leads, out);
            else
                copy(i, words, out);
        }
    });
    return dropUnused(out);
}

}  // namespace nacre::gpu
