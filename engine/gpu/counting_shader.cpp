#include "engine/gpu/counting_shader.h"

#include <optional>
#include <stdexcept>
#include <vector>

#include "engine/gpu/spirv.h"

namespace nacre::gpu {
namespace {

using namespace spirv;
constexpr std::uint32_t kBlock = 2, kBinding = 33, kDescriptorSet = 34, kOffset = 35;  // decorations
constexpr std::uint32_t kStorageBuffer = 12, kDeviceScope = 1;
constexpr const char* kNoCounter = "a shader without countFragment()";

bool isCounter(const Instruction& i) { return namesFunction(i, "countFragment"); }

std::vector<std::uint32_t> withCounter(std::span<const std::uint32_t> words) {
    if (words.size() < kHeader) throw std::logic_error("no shader");
    const std::uint32_t counter = require(words, kHeader, kNoCounter, isCounter).operands[0];
    const auto isType = [](const Instruction& i) { return i.operation >= kOpTypeVoid && i.operation < kOpFunction; };
    const std::size_t types = require(words, kHeader, kNoCounter, isType).at;
    const std::size_t functions =
        require(words, types, kNoCounter, [](const Instruction& i) { return i.operation == kOpFunction; }).at;
    const std::size_t function = require(words, functions, kNoCounter, [&](const Instruction& i) {
                                     return i.operation == kOpFunction && i.operands[1] == counter;
                                 }).at;
    const std::size_t label =
        require(words, function, kNoCounter, [](const Instruction& i) { return i.operation == kOpLabel; }).at;
    const std::size_t body = label + 2;

    std::uint32_t next = words[kBound];
    const std::optional<Instruction> number = find(words.first(functions), types, [](const Instruction& i) {
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
    static Derived derived;
    return derived.get(words, withCounter);
}

}  // namespace nacre::gpu
