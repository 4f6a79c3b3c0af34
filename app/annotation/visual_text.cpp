#include "app/annotation/visual_text.h"

#include <hb.h>

#include <array>
#include <optional>
#include <vector>

#include "app/annotation/bidi.h"
#include "app/files/code_points.h"

namespace nacre::app {
namespace {

constexpr char32_t kFirstLetter = 0x621, kTatweel = 0x640, kLam = 0x644;
/// Number of presentation forms of the Arabic letters from U+0621 on, consecutive from U+FE80 on: isolated, final,
/// initial, medial. 1: joins no neighbour; 2: joins the previous one; 4: joins both; 0: no letter.
constexpr std::array<int, 42> kForms = {1, 2, 2, 2, 2, 4, 2, 4, 2, 4, 4, 4, 4, 4, 2, 2, 2, 2, 4, 4, 4,
                                        4, 4, 4, 4, 4, 0, 0, 0, 0, 0, 0, 4, 4, 4, 4, 4, 4, 4, 2, 2, 4};

int countForms(char32_t c) {
    return c >= kFirstLetter && c < kFirstLetter + kForms.size() ? kForms[c - kFirstLetter] : 0;
}
char32_t findFirstForm(char32_t c) {
    char32_t form = 0xfe80;
    for (char32_t before = kFirstLetter; before < c; ++before) form += static_cast<char32_t>(countForms(before));
    return form;
}
bool isMark(char32_t c) { return findBidiClass(c) == BidiClass::NSM; }
bool joinsNext(char32_t c) { return countForms(c) == 4 || c == kTatweel; }
bool joinsPrevious(char32_t c) { return countForms(c) > 1 || c == kTatweel; }

/// The isolated form of lam with this alef, if they form a ligature.
std::optional<char32_t> lamWith(char32_t alef) {
    switch (alef) {
        case 0x622:
            return 0xfef5;
        case 0x623:
            return 0xfef7;
        case 0x625:
            return 0xfef9;
        case 0x627:
            return 0xfefb;
        default:
            return {};
    }
}

/// Replaces Arabic letters by their forms next to their neighbours. @param text  in logical order
std::vector<char32_t> joined(std::vector<char32_t> text) {
    std::vector<char32_t> out;
    char32_t before = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char32_t c = text[i];
        const bool previous = joinsNext(before) && joinsPrevious(c);
        if (const auto ligature = c == kLam && i + 1 < text.size() ? lamWith(text[i + 1]) : std::nullopt) {
            out.push_back(*ligature + (previous ? 1 : 0));
            before = text[++i];
            continue;
        }
        std::size_t next = i + 1;
        while (next < text.size() && isMark(text[next])) ++next;
        const bool following = joinsNext(c) && next < text.size() && joinsPrevious(text[next]);
        if (countForms(c) == 0)
            out.push_back(c);
        else
            out.push_back(findFirstForm(c) + (following ? 2 : 0) + (previous ? 1 : 0));
        if (!isMark(c)) before = c;
    }
    return out;
}

void append(std::string& text, char32_t c) {
    const std::u16string one = c < 0x10000 ? std::u16string{static_cast<char16_t>(c)}
                                           : std::u16string{static_cast<char16_t>(0xd7c0 + (c >> 10)),
                                                            static_cast<char16_t>(0xdc00 + (c & 0x3ff))};
    text += toUtf8(one);
}

}  // namespace

std::string visualText(const std::string& text) {
    if (!mayRunFromRight(text)) return text;
    const std::vector<char32_t> points = codePoints(text);
    std::string out;
    for (const DirectedRun& run : visualRuns(points)) {
        const auto first = points.begin() + static_cast<std::ptrdiff_t>(run.first);
        std::vector<char32_t> part(first, first + static_cast<std::ptrdiff_t>(run.count));
        if (!run.rightToLeft) {
            for (const char32_t c : part)
                if (findBidiClass(c) != BidiClass::BN) append(out, c);
            continue;
        }
        part = joined(std::move(part));
        for (std::size_t end = part.size(); end > 0;) {
            std::size_t base = end - 1;
            while (base > 0 && isMark(part[base])) --base;
            for (std::size_t i = base; i < end; ++i)  // marks stay after their letter
                if (findBidiClass(part[i]) != BidiClass::BN)
                    append(out, static_cast<char32_t>(hb_unicode_mirroring(hb_unicode_funcs_get_default(), part[i])));
            end = base;
        }
    }
    // Removes direction marks, which are no longer needed.
    for (const char* mark : {"\xe2\x80\x8e", "\xe2\x80\x8f", "\xd8\x9c"})
        for (std::size_t at; (at = out.find(mark)) != std::string::npos;) out.erase(at, std::string(mark).size());
    return out;
}

bool mayRunFromRight(const std::string& text) {
    // There is no right-to-left character below U+0590.
    for (const char c : text)
        if (static_cast<unsigned char>(c) >= 0xd6) return true;
    return false;
}

}  // namespace nacre::app
