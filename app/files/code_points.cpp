#include "app/files/code_points.h"

namespace nacre::app {
namespace {

constexpr char32_t kReplacement = 0xfffd;

void appendUtf8(std::string& out, char32_t c) {
    const int more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    constexpr unsigned kLead[] = {0, 0xc0, 0xe0, 0xf0};
    out += static_cast<char>(kLead[more] | c >> (6 * more));
    for (int i = more - 1; i >= 0; --i) out += static_cast<char>(0x80 | (c >> (6 * i) & 0x3f));
}

}  // namespace

CodePoint firstCodePoint(std::string_view text) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = at(0);
    if (first < 0x80) return {first, 1, true};
    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < bytes) return {first, 1, false};
    std::uint32_t code = first & (0xffu >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((at(i) & 0xc0) != 0x80) return {first, 1, false};
        code = code << 6 | (at(i) & 0x3fu);
    }
    const bool overlong = (bytes == 3 && code < 0x800) || (bytes == 4 && code < 0x10000);
    if (overlong || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return {first, 1, false};
    return {code, bytes, true};
}

std::vector<char32_t> codePoints(std::string_view text) {
    std::vector<char32_t> all;
    while (!text.empty()) {
        const CodePoint point = firstCodePoint(text);
        all.push_back(point.valid ? point.code : kReplacement);
        text.remove_prefix(point.bytes);
    }
    return all;
}

std::u16string toUtf16(std::string_view utf8) {
    std::u16string out;
    for (const char32_t c : codePoints(utf8)) {
        if (c >= 0x10000) out += static_cast<char16_t>(0xd800 + ((c - 0x10000) >> 10));
        out += static_cast<char16_t>(c >= 0x10000 ? 0xdc00 + (c & 0x3ff) : c);
    }
    return out;
}

std::string toUtf8(std::u16string_view utf16) {
    std::string out;
    for (std::size_t i = 0; i < utf16.size(); ++i) {
        char32_t c = utf16[i];
        const bool high = c >= 0xd800 && c < 0xdc00, low = c >= 0xdc00 && c < 0xe000;
        if (high && i + 1 < utf16.size() && utf16[i + 1] >= 0xdc00 && utf16[i + 1] < 0xe000)
            c = 0x10000 + ((c - 0xd800) << 10) + (utf16[++i] - 0xdc00u);
        else if (high || low)
            c = kReplacement;
        appendUtf8(out, c);
    }
    return out;
}

}  // namespace nacre::app
