#pragma once
// Writes MessagePack, for tests of the formats made of it.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nacre::test {

inline std::string bigEndian(std::uint64_t value, int bytes) {
    std::string text;
    while (bytes-- > 0) text += static_cast<char>(value >> 8 * bytes);
    return text;
}
inline std::string littleEndian(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i);
    return text;
}

inline std::string packInteger(std::int64_t value) { return '\xD3' + bigEndian(static_cast<std::uint64_t>(value), 8); }
inline std::string packNumber(double value) {
    std::uint64_t bits = 0;
    static_assert(sizeof bits == sizeof value);
    __builtin_memcpy(&bits, &value, sizeof bits);
    return '\xCB' + bigEndian(bits, 8);
}
inline std::string packBoolean(bool value) { return value ? "\xC3" : "\xC2"; }
inline std::string packText(std::string_view text) { return '\xDB' + bigEndian(text.size(), 4) + std::string(text); }
inline std::string packBinary(std::string_view bytes) {
    return '\xC6' + bigEndian(bytes.size(), 4) + std::string(bytes);
}
inline std::string packArray(const std::vector<std::string>& elements) {
    std::string text = '\xDD' + bigEndian(elements.size(), 4);
    for (const std::string& element : elements) text += element;
    return text;
}
/// @param pairs keys, and values that are packed already
inline std::string packMap(const std::vector<std::pair<std::string, std::string>>& pairs) {
    std::string text = '\xDF' + bigEndian(pairs.size(), 4);
    for (const auto& [key, value] : pairs) text += packText(key) + value;
    return text;
}

}  // namespace nacre::test
