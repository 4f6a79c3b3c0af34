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
    kOpPhi = 245,
    kOpSelectionMerge = 247,
    kOpBranch = 249,
    kOpBranchConditional = 250,
};

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
    // Blocks that nothing reaches stay: names and decorations refer to what they define.
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
            const std::size_t at = out.size();
            out.insert(out.end(), words.begin() + static_cast<std::ptrdiff_t>(i.at),
                       words.begin() + static_cast<std::ptrdiff_t>(i.end()));
            if (i.operation != kOpPhi) return;
            out.resize(at + 3);  // its type and result
            for (std::size_t pair = 2; pair + 1 < i.operands.size(); pair += 2)
                if (!dropped.contains({i.operands[pair + 1], block}))
                    out.insert(out.end(), {i.operands[pair], i.operands[pair + 1]});
            out[at] = static_cast<std::uint32_t>(out.size() - at) << 16 | kOpPhi;
        }
    });
    return out;
}

}  // namespace nacre::gpu
