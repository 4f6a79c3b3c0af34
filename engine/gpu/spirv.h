#pragma once
// Reading and writing the instructions of a SPIR-V module, for stages that are made from other stages.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace nacre::gpu::spirv {

// Numbers of the SPIR-V specification, version 1.3.
constexpr std::size_t kHeader = 5, kBound = 3;  // in words; position of the bound, above all ids
enum : std::uint32_t {
    kOpName = 5,
    kOpEntryPoint = 15,
    kOpCapability = 17,
    kOpTypeVoid = 19,
    kOpTypeInt = 21,
    kOpTypeVector = 23,
    kOpTypeImage = 25,
    kOpTypeSampledImage = 27,
    kOpTypeStruct = 30,
    kOpTypePointer = 32,
    kOpConstantTrue = 41,
    kOpConstantFalse = 42,
    kOpConstant = 43,
    kOpSpecConstantTrue = 48,
    kOpSpecConstantFalse = 49,
    kOpSpecConstant = 50,
    kOpSpecConstantOp = 52,
    kOpFunction = 54,
    kOpFunctionEnd = 56,
    kOpFunctionCall = 57,
    kOpVariable = 59,
    kOpLoad = 61,
    kOpStore = 62,
    kOpCopyMemory = 63,
    kOpAccessChain = 65,
    kOpDecorate = 71,
    kOpMemberDecorate = 72,
    kOpCompositeConstruct = 80,
    kOpImageFetch = 95,
    kOpImageWrite = 99,
    kOpImage = 100,
    kOpLogicalEqual = 164,
    kOpLogicalNotEqual = 165,
    kOpLogicalOr = 166,
    kOpLogicalAnd = 167,
    kOpLogicalNot = 168,
    kOpIEqual = 170,
    kOpINotEqual = 171,
    kOpUGreaterThan = 172,
    kOpSGreaterThan = 173,
    kOpUGreaterThanEqual = 174,
    kOpSGreaterThanEqual = 175,
    kOpULessThan = 176,
    kOpSLessThan = 177,
    kOpULessThanEqual = 178,
    kOpSLessThanEqual = 179,
    kOpControlBarrier = 224,
    kOpMemoryBarrier = 225,
    kOpAtomicStore = 228,
    kOpAtomicIAdd = 234,
    kOpPhi = 245,
    kOpLoopMerge = 246,
    kOpSelectionMerge = 247,
    kOpLabel = 248,
    kOpBranch = 249,
    kOpBranchConditional = 250,
    kOpSwitch = 251,
    kOpReturnValue = 254,
};

using Words = std::span<const std::uint32_t>;

struct Instruction {
    std::size_t at;  ///< its first word
    std::uint32_t operation;
    Words operands;
    std::size_t end() const { return at + 1 + operands.size(); }
};

/// @returns the first that fits, from a position on
template <typename Fits>
std::optional<Instruction> find(Words words, std::size_t from, const Fits& fits) {
    for (std::size_t at = from; at < words.size();) {
        const std::size_t length = words[at] >> 16;
        if (length == 0 || length > words.size() - at) break;
        const Instruction i{at, words[at] & 0xffff, words.subspan(at + 1, length - 1)};
        if (fits(i)) return i;
        at += length;
    }
    return std::nullopt;
}

/// As find(). @param missing  what the error says @throws std::logic_error if none fits
template <typename Fits>
Instruction require(Words words, std::size_t from, const char* missing, const Fits& fits) {
    if (const std::optional<Instruction> found = find(words, from, fits)) return *found;
    throw std::logic_error(missing);
}

/// The text that begins at an operand.
inline std::string_view text(Words operands, std::size_t first) {
    const std::string_view all(reinterpret_cast<const char*>(operands.data() + first), 4 * (operands.size() - first));
    return all.substr(0, all.find('\0'));
}

/// Whether an instruction names a function. glslang appends the parameters' types to its name and "(".
inline bool namesFunction(const Instruction& i, std::string_view name) {
    if (i.operation != kOpName || i.operands.size() < 2) return false;
    const std::string_view named = text(i.operands, 1);
    return named.starts_with(name) && named.substr(name.size()).starts_with("(");
}

inline void append(std::vector<std::uint32_t>& to, std::uint32_t operation,
                   std::initializer_list<std::uint32_t> operands) {
    to.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | operation);
    to.insert(to.end(), operands);
}

/// Modules made from others, once each. For any thread; what it returns stays.
class Derived {
public:
    /// @param words  what it is made from, which stays at its place
    template <typename Make>
    Words get(Words words, const Make& make) {
        const std::lock_guard lock(turn_);
        std::vector<std::uint32_t>& made = made_[words.data()];
        if (made.empty()) made = make(words);
        return made;
    }

private:
    std::mutex turn_;
    std::map<const std::uint32_t*, std::vector<std::uint32_t>> made_;
};

}  // namespace nacre::gpu::spirv
