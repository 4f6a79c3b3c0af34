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

// Beside those of spirv.h.
constexpr std::uint32_t kSpecId = 1;  // decoration
enum : std::uint32_t {
    kOpConstantTrue = 41,
    kOpConstantFalse = 42,
    kOpSpecConstantTrue = 48,
    kOpSpecConstantFalse = 49,
    kOpSpecConstant = 50,
    kOpSpecConstantOp = 52,
    kOpLogicalEqual = 164,
    kOpLogicalNotEqual = 165,
    kOpLogicalOr = 166,
    kOpLogicalAnd = 167,
    kOpLogicalNot = 168,
    kOpIEqual = 170,
    kOpINotEqual = 171,
    kOpUGreaterThan = 172,
    kOpSGreaterThan = 173,
    kOpULessThan = 176,
    kOpSLessThan = 177,
    kOpFunctionEnd = 56,
    kOpFunctionCall = 57,
    kOpStore = 62,
    kOpCopyMemory = 63,
    kOpImageWrite = 99,
    kOpControlBarrier = 224,
    kOpMemoryBarrier = 225,
    kOpAtomicStore = 228,
    kOpPhi = 245,
    kOpLoopMerge = 246,
    kOpSelectionMerge = 247,
    kOpBranch = 249,
    kOpBranchConditional = 250,
    kOpSwitch = 251,
    kOpUnreachable = 255,
};
constexpr std::uint32_t kVertex = 0, kFragment = 4;  // execution models
constexpr std::uint32_t kInput = 1, kOutput = 3;     // storage classes
constexpr std::uint32_t kLocation = 30;              // decoration

template <typename Visit>
void forEach(Words words, const Visit& visit) {
    find(words, kHeader, [&](const Instruction& i) {
        visit(i);
        return false;
    });
}

/// Scalars of 32 bits and booleans that are known.
class Constants {
public:
    Constants(Words words, const Specialization& given) {
        std::map<std::uint32_t, std::uint32_t> numbers;  // SpecId of each constant
        forEach(words, [&](const Instruction& i) {
            if (i.operation == kOpDecorate && i.operands.size() == 3 && i.operands[1] == kSpecId)
                numbers[i.operands[0]] = i.operands[2];
            else if (i.operands.size() >= 2)
                add(i, numbers, given);
        });
    }
    std::optional<std::uint32_t> value(std::uint32_t id) const {
        const auto found = values_.find(id);
        return found == values_.end() ? std::nullopt : std::optional(found->second);
    }

private:
    void add(const Instruction& i, const std::map<std::uint32_t, std::uint32_t>& numbers, const Specialization& given) {
        const std::uint32_t id = i.operands[1];
        const auto specialized = [&](std::uint32_t standard) {
            const auto number = numbers.find(id);
            return number == numbers.end() ? standard : given.value(number->second).value_or(standard);
        };
        switch (i.operation) {
            case kOpConstantTrue:
                values_[id] = 1;
                break;
            case kOpConstantFalse:
                values_[id] = 0;
                break;
            case kOpConstant:
                if (i.operands.size() == 3) values_[id] = i.operands[2];
                break;
            case kOpSpecConstantTrue:
                values_[id] = specialized(1);
                break;
            case kOpSpecConstantFalse:
                values_[id] = specialized(0);
                break;
            case kOpSpecConstant:
                if (i.operands.size() == 3) values_[id] = specialized(i.operands[2]);
                break;
            case kOpSpecConstantOp:
                if (i.operands.size() >= 4) compute(id, i.operands[2], i.operands.subspan(3));
                break;
            default:  // glslang also writes expressions of constants as plain instructions
                if (i.operands.size() >= 3) compute(id, i.operation, i.operands.subspan(2));
        }
    }

    void compute(std::uint32_t id, std::uint32_t operation, Words operands) {
        const std::optional<std::uint32_t> first = value(operands[0]);
        if (!first) return;
        if (operation == kOpLogicalNot) {
            values_[id] = *first == 0 ? 1 : 0;
            return;
        }
        const std::optional<std::uint32_t> second = operands.size() == 2 ? value(operands[1]) : std::nullopt;
        if (!second) return;
        const auto a = *first, b = *second;
        switch (operation) {
            case kOpLogicalEqual:
            case kOpIEqual:
                values_[id] = a == b ? 1 : 0;
                break;
            case kOpLogicalNotEqual:
            case kOpINotEqual:
                values_[id] = a != b ? 1 : 0;
                break;
            case kOpLogicalOr:
                values_[id] = a | b;
                break;
            case kOpLogicalAnd:
                values_[id] = a & b;
                break;
            case kOpUGreaterThan:
                values_[id] = a > b ? 1 : 0;
                break;
            case kOpSGreaterThan:
                values_[id] = static_cast<std::int32_t>(a) > static_cast<std::int32_t>(b) ? 1 : 0;
                break;
            case kOpULessThan:
                values_[id] = a < b ? 1 : 0;
                break;
            case kOpSLessThan:
                values_[id] = static_cast<std::int32_t>(a) < static_cast<std::int32_t>(b) ? 1 : 0;
                break;
            default:
                break;
        }
    }

    std::map<std::uint32_t, std::uint32_t> values_;
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

/// Drops blocks and functions that nothing reaches, and the outputs of a vertex stage and the inputs of a fragment
/// stage that nothing else uses.
std::vector<std::uint32_t> dropUnused(Words words) {
    const Reached reached(words);
    std::vector<bool> kept;  // of each instruction
    std::set<std::uint32_t> used, gone, located;
    std::uint32_t stage = ~0u;
    bool in = true, function = true, body = false;  // in what runs, or outside functions
    forEach(words, [&](const Instruction& i) {
        if (i.operation == kOpEntryPoint) stage = i.operands[0];
        if (i.operation == kOpDecorate && i.operands[1] == kLocation) located.insert(i.operands[0]);
        if (i.operation == kOpFunction) in = function = reached(i.operands[1]), body = true;
        if (i.operation == kOpLabel) in = reached(i.operands[0]);
        if (i.operation == kOpFunctionEnd) in = function;
        kept.push_back(in);
        if (!in) {
            if (const std::optional<std::uint32_t> result = resultOf(i)) gone.insert(*result);
        } else if (body) {
            used.insert(i.operands.begin(), i.operands.end());
        }
        if (i.operation == kOpFunctionEnd) in = true, body = false;
    });
    const std::uint32_t passed = stage == kVertex ? kOutput : stage == kFragment ? kInput : ~0u;
    const auto drops = [&](const Instruction& i) {
        return i.operation == kOpVariable && i.operands[2] == passed && located.contains(i.operands[1]) &&
               !used.contains(i.operands[1]);
    };
    forEach(words, [&](const Instruction& i) {
        if (drops(i)) gone.insert(i.operands[1]);
    });
    std::vector<std::uint32_t> out(words.begin(), words.begin() + kHeader);
    out.reserve(words.size());
    std::size_t next = 0;
    forEach(words, [&](const Instruction& i) {
        const bool keeps = kept[next++];
        if (!keeps || drops(i)) return;
        if ((i.operation == kOpName || i.operation == kOpDecorate) && gone.contains(i.operands[0])) return;
        if (i.operation == kOpPhi) return copyPhi(i, reached, out);
        const std::size_t at = out.size();
        copy(i, words, out);
        if (i.operation != kOpEntryPoint) return;
        const auto isGone = [&](std::uint32_t id) { return gone.contains(id); };
        const std::size_t name = (text(i.operands, 2).size() + 4) / 4;
        out.erase(std::remove_if(out.begin() + static_cast<std::ptrdiff_t>(at + 3 + name), out.end(), isGone),
                  out.end());
        out[at] = static_cast<std::uint32_t>(out.size() - at) << 16 | kOpEntryPoint;
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
            if (const std::optional<std::uint32_t> holds = known.value(i.operands[0])) {
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
            if (i.operation == kOpPhi)
                copyPhi(
                    i,
                    [&](std::uint32_t from) {
                        return !dropped.contains({from, block});
                    },
                    out);
            else
                copy(i, words, out);
        }
    });
    return dropUnused(out);
}

}  // namespace nacre::gpu
