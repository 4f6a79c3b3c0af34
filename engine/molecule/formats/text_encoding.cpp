#include "engine/molecule/formats/text_encoding.h"

#include <cstddef>

#include "engine/molecule/text.h"

namespace nacre {
namespace {

constexpr std::uint32_t kReplacement = 0xFFFD;

bool leads(std::uint32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
bool trails(std::uint32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

}  // namespace

void appendUtf8(std::string& text, std::uint32_t character) {
    const auto byte = [&](std::uint32_t bits) { text.push_back(static_cast<char>(bits)); };
    const auto follow = [&](int shift) { byte(0x80u | ((character >> shift) & 0x3Fu)); };
    if (character < 0x80) return byte(character);
    if (character < 0x800) {
        byte(0xC0u | (character >> 6));
    } else {
        if (character < 0x10000) {
            byte(0xE0u | (character >> 12));
        } else {
            byte(0xF0u | (character >> 18));
            follow(12);
        }
        follow(6);
    }
    follow(0);
}

std::optional<std::string> utf8FromUtf16(std::string_view text) {
    const bool little = startsWith(text, "\xff\xfe");
    if (!little && !startsWith(text, "\xfe\xff")) return std::nullopt;
    const auto unitAt = [&](std::size_t i) -> std::uint32_t {
        if (i + 1 >= text.size()) return kReplacement;
        const auto first = static_cast<unsigned char>(text[i]), second = static_cast<unsigned char>(text[i + 1]);
        return little ? first | std::uint32_t{second} << 8 : second | std::uint32_t{first} << 8;
    };
    std::string utf8;
    utf8.reserve(text.size() / 2);
    for (std::size_t i = 2; i < text.size(); i += 2) {
        std::uint32_t character = unitAt(i);
        if (leads(character) && trails(unitAt(i + 2))) {
            character = 0x10000 + ((character - 0xD800) << 10) + (unitAt(i + 2) - 0xDC00);
            i += 2;
        } else if (leads(character) || trails(character)) {
            character = kReplacement;
        }
        appendUtf8(utf8, character);
    }
    return utf8;
}

}  // namespace nacre
