#include "engine/gpu/counting_shader.h"

#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace nacre::gpu {
namespace {

// Numbers of the SPIR-V specification, version 1.3.
constexpr std::size_t kHeader = 5, kBound = 3;  // in words; position of the bound, above all ids
enum : std::uint32_t {
    kOpName = 5,
    kOpTypeVoid = 19,
    kOpTypeInt = 21,
    kOpTypeStruct = 30,
    kOpTypePointer = 32,
    kOpConstant = 43,
    kOpFunction = 54,
    kOpVariable = 59,
    kOpAccessChain = 65,
    kOpDecorate = 71,
    kOpMemberDecorate = 72,
    kOpAtomicIAdd = 234,
    kOpLabel = 248,
};
constexpr std::uint32_t kBlock = 2, kBinding = 33, kDescriptorSet = 34, kOffset = 35;  // decorations
constexpr std::uint32_t kStorageBuffer = 12, kDeviceScope = 1;

struct Instruction {
    std::size_t at;  ///< its first word
    std::uint32_t operation;
    std::span<const std::uint32_t> operands;
};

/// @returns the first that fits, from a position on
template <typename Fits>
std::optional<Instruction> findInstruction(std::span<const std::uint32_t> words, std::size_t from, const Fits& fits) {
    for (std::size_t at = from; at < words.size();) {
        const std::size_t length = words[at] >> 16;
        if (length == 0 || length > words.size() - at) break;
        const Instruction i{at, words[at] & 0xffff, words.subspan(at + 1, length - 1)};
        if (fits(i)) return i;
        at += length;
    }
    return std::nullopt;
}

template <typename Fits>
Instruction require(std::span<const std::uint32_t> words, std::size_t from, const Fits& fits) {
    if (const std::optional<Instruction> found = findInstruction(words, from, fits)) return *found;
    throw std::logic_error("a shader without countFragment()");
}

bool isCounter(const Instruction& i) {
    constexpr std::string_view kName = "countFragment(";  // glslang appends the parameters' types
    if (i.operation != kOpName || i.operands.size() < 2) return false;
    const std::string_view name(reinterpret_cast<const char*>(i.operands.data() + 1), 4 * (i.operands.size() - 1));
    return name.substr(0, name.find('\0')) == kName;
}

void append(std::vector<std::uint32_t>& to, std::uint32_t operation, std::initializer_list<std::uint32_t> operands) {
    to.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | operation);
    to.insert(to.end(), operands);
}

std::vector<std::uint32_t> withCounter(std::span<const std::uint32_t> words) {
    if (words.size() < kHeader) throw std::logic_error("no shader");
    const std::uint32_t counter = require(words, kHeader, isCounter).operands[0];
    const auto isType = [](const Instruction& i) { return i.operation >= kOpTypeVoid && i.operation < kOpFunction; };
    const std::size_t types = require(words, kHeader, isType).at;
    const std::size_t functions =
        require(words, types, [](const Instruction& i) { return i.operation == kOpFunction; }).at;
    const std::size_t function = require(words, functions, [&](const Instruction& i) {
                                     return i.operation == kOpFunction && i.operands[1] == counter;
                                 }).at;
    const std::size_t label = require(words, function, [](const Instruction& i) { return i.operation == kOpLabel; }).at;
    const std::size_t body = label + 2;

    std::uint32_t next = words[kBound];
    const std::optional<Instruction> number = findInstruction(words.first(functions), types, [](const Instruction& i) {
        return i.operation == kOpTypeInt && i.operands[1] == 32 && i.operands[2] == 0;
    });
    const std::uint32_t word = number ? number->operands[0] : next++;
    const std::uint32_t block = next++, blockPointer = next++, wordPointer = next++, zero = next++, one = next++,
                        scope = next++, buffer = next++, place = next++, before = next++;

    std::vector<std::uint32_t> out(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(types));
    append(out, kOpMemberDecorate, {block, 0, kOffset, 0});
    append(out, kOpDecorate, {block, kBlock});
    append(out, kOpDecorate, {buffer, kDescriptorSet, 1});
    append(out, kOpDecorate, {buffer, kBinding, 0});
    const auto copy = [&](std::size_t from, std::size_t end) {
        out.insert(out.end(), words.begin() + static_cast<std::ptrdiff_t>(from),
                   words.begin() + static_cast<std::ptrdiff_t>(end));
    };
    copy(types, functions);
    if (!number) append(out, kOpTypeInt, {word, 32, 0});
    append(out, kOpTypeStruct, {block, word});
    append(out, kOpTypePointer, {blockPointer, kStorageBuffer, block});
    append(out, kOpTypePointer, {wordPointer, kStorageBuffer, word});
    append(out, kOpConstant, {word, zero, 0});
    append(out, kOpConstant, {word, one, 1});
    append(out, kOpConstant, {word, scope, kDeviceScope});
    append(out, kOpVariable, {blockPointer, buffer, kStorageBuffer});
    copy(functions, body);
    append(out, kOpAccessChain, {wordPointer, place, buffer, zero});
    append(out, kOpAtomicIAdd, {word, before, place, scope, zero, one});  // relaxed
    copy(body, words.size());
    out[kBound] = next;
    return out;
}

}  // namespace

std::span<const std::uint32_t> countingShader(std::span<const std::uint32_t> words) {
    static std::mutex mutex;
    static std::map<const std::uint32_t*, std::vector<std::uint32_t>> made;  // addresses stay
    const std::lock_guard lock(mutex);
    std::vector<std::uint32_t>& counting = made[words.data()];
    if (counting.empty()) counting = withCounter(words);
    return counting;
}

}  // namespace nacre::gpu
