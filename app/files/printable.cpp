#include "app/files/printable.h"

#include <cstdint>
#include <cstdio>

#include "app/files/code_points.h"

namespace nacre::app {
namespace {

/// Characters that control a terminal, or change the direction of text.
bool commands(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7f && code <= 0x9f) || code == 0x61c || code == 0x200e || code == 0x200f ||
           (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0xfeff ||
           (code >= 0xe0000 && code <= 0xe007f);
}

std::string escaped(std::uint32_t code) {
    char text[16];
    std::snprintf(text, sizeof text, code < 0x100 ? "\\x%02x" : "\\u%04x", static_cast<unsigned>(code));
    return text;
}

std::string shown(std::string_view text, bool keepLines) {
    std::string out;
    while (!text.empty()) {
        const CodePoint sign = firstCodePoint(text);
        if (sign.valid && keepLines && sign.code == '\n')
            out += '\n';
        else if (sign.valid && (sign.code == '\n' || sign.code == '\r' || sign.code == '\t'))
            out += ' ';
        else if (!sign.valid || commands(sign.code))
            out += escaped(sign.code);
        else
            out += text.substr(0, sign.bytes);
        text.remove_prefix(sign.bytes);
    }
    return out;
}

}  // namespace

std::string printable(std::string_view text) { return shown(text, false); }

std::string shortened(const std::string& text) {
    constexpr std::size_t kMost = 2000, kEnd = 500;
    constexpr std::string_view kGap = " ... ";
    if (text.size() <= kMost) return text;
    return text.substr(0, kMost - kEnd - kGap.size()) + std::string(kGap) + text.substr(text.size() - kEnd);
}

std::string printableLines(std::string_view text) { return shown(text, true); }

std::string printableJson(std::string_view json) {
    std::string out;
    while (!json.empty()) {
        const CodePoint sign = firstCodePoint(json);
        if (sign.code >= 0x7f && sign.code <= 0xffff && commands(sign.code)) {
            char text[8];
            std::snprintf(text, sizeof text, "\\u%04x", static_cast<unsigned>(sign.code));
            out += text;
        } else {
            out += json.substr(0, sign.bytes);
        }
        json.remove_prefix(sign.bytes);
    }
    return out;
}

}  // namespace nacre::app
