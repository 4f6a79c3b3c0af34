#pragma once
// Bytes that a vertex stage hands on, by its SPIR-V.

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

namespace nacre::test {

/// Bytes of a vertex stage's outputs beside its position.
inline std::uint32_t outputBytes(std::span<const std::uint32_t> words) {
    constexpr std::uint32_t kInt = 21, kFloat = 22, kVector = 23, kPointer = 32, kVariable = 59, kOutput = 3;
    std::map<std::uint32_t, std::uint32_t> bytes, pointed;
    std::uint32_t sum = 0;
    for (std::size_t i = 5; i < words.size(); i += words[i] >> 16) {
        const auto word = [&](std::size_t k) { return words[i + k]; };
        switch (words[i] & 0xffffu) {
            case kInt:
            case kFloat:
                bytes[word(1)] = word(2) / 8;
                break;
            case kVector:
                bytes[word(1)] = bytes[word(2)] * word(3);
                break;
            case kPointer:
                pointed[word(1)] = word(3);
                break;
            case kVariable:
                if (word(3) == kOutput && bytes.count(pointed[word(1)])) sum += bytes[pointed[word(1)]];  // no block
                break;
            default:
                break;
        }
    }
    return sum;
}

}  // namespace nacre::test
