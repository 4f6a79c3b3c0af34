#include "app/annotation/bidi.h"

#include <hb.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace nacre::app {
namespace {

using enum BidiClass;

BidiClass classOfControl(char32_t c) {
    switch (c) {
        case 0x200e:
            return L;
        case 0x200f:
            return R;
        case 0x61c:
            return AL;
        case 0x202a:
            return LRE;
        case 0x202b:
            return RLE;
        case 0x202c:
            return PDF;
        case 0x202d:
            return LRO;
        case 0x202e:
            return RLO;
        case 0x2066:
            return LRI;
        case 0x2067:
            return RLI;
        case 0x2068:
            return FSI;
        case 0x2069:
            return PDI;
        default:
            return BN;
    }
}

bool isOneOf(char32_t c, std::u32string_view list) { return list.find(c) != list.npos; }

BidiClass classOfSymbol(char32_t c, hb_unicode_general_category_t category) {
    if (c == 0x60b) return AL;  // the afghani sign
    if (isOneOf(c, U"+-\u207a\u207b\u208a\u208b\u2212\ufb29\ufe62\ufe63\uff0b\uff0d")) return ES;
    if (isOneOf(c, U",./:\u060c\u2044\ufe50\ufe52\ufe55\uff0c\uff0e\uff0f\uff1a")) return CS;
    if (category == HB_UNICODE_GENERAL_CATEGORY_CURRENCY_SYMBOL ||
        isOneOf(c,
                U"#%\u00b0\u00b1\u0609\u060a\u066a\u2030\u2031\u2032\u2033\u2034\u2213\u212e\ufe5f\ufe6a\uff03\uff05"))
        return ET;
    return ON;
}

BidiClass classOfNumber(char32_t c, hb_unicode_general_category_t category) {
    if ((c >= 0x660 && c <= 0x669) || isOneOf(c, U"\u066b\u066c")) return AN;
    const bool digit = category == HB_UNICODE_GENERAL_CATEGORY_DECIMAL_NUMBER;
    if (digit && (c < 0x80 || (c >= 0x6f0 && c <= 0x6f9) || (c >= 0xff10 && c <= 0xff19))) return EN;
    if (isOneOf(c, U"\u00b2\u00b3\u00b9") || (c >= 0x2070 && c <= 0x2089)) return EN;
    const bool other = category == HB_UNICODE_GENERAL_CATEGORY_OTHER_NUMBER;
    return other && (c < 0x900 || (c >= 0x2150 && c < 0x3000)) ? ON : L;  // fractions, circled digits
}

/// For the blocks that Unicode reserves for right-to-left scripts, assigned or not.
BidiClass classOfBlock(char32_t c) {
    const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
    if (within(0x600, 0x7bf) || within(0x860, 0x8ff) || within(0xfb50, 0xfdff) || within(0xfe70, 0xfeff)) return AL;
    if (within(0x590, 0x85f) || within(0xfb1d, 0xfb4f) || within(0x10800, 0x10fff) || within(0x1e800, 0x1efff))
        return R;
    return L;
}

BidiClass classOfLetter(char32_t c) {
    const hb_script_t script = hb_unicode_script(hb_unicode_funcs_get_default(), c);
    const bool common = script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_UNKNOWN;
    if (common || hb_script_get_horizontal_direction(script) == HB_DIRECTION_RTL) return classOfBlock(c);
    return L;
}

/// Class of other punctuation and symbols. Those used by a single script have its direction.
BidiClass classOfSign(char32_t c) {
    const hb_script_t script = hb_unicode_script(hb_unicode_funcs_get_default(), c);
    const bool shared = script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_GREEK ||
                        script == HB_SCRIPT_LATIN;
    if (isOneOf(c, U"\u060d\u061b\u061f\u0608")) return AL;
    if ((c >= 0x606 && c <= 0x60f) || c == 0x6de || c == 0x6e9 || (c >= 0x7f6 && c <= 0x7f9)) return ON;
    return shared ? ON : classOfLetter(c);
}

}  // namespace

BidiClass findBidiClass(char32_t c) {
    if (c == '\n' || c == '\r' || c == 0x2029 || c == 0x85 || (c >= 0x1c && c <= 0x1e)) return B;
    if (c == '\t' || c == 0x0b || c == 0x1f) return S;
    if (c == 0x0c) return WS;
    if (c == 0xa0 || c == 0x202f) return CS;
    const hb_unicode_general_category_t category = hb_unicode_general_category(hb_unicode_funcs_get_default(), c);
    switch (category) {
        case HB_UNICODE_GENERAL_CATEGORY_CONTROL:
            return BN;
        case HB_UNICODE_GENERAL_CATEGORY_FORMAT:
            return (c >= 0x600 && c <= 0x605) || c == 0x6dd ? AN : classOfControl(c);
        case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
        case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
            return NSM;
        case HB_UNICODE_GENERAL_CATEGORY_LINE_SEPARATOR:
        case HB_UNICODE_GENERAL_CATEGORY_SPACE_SEPARATOR:
            return WS;
        case HB_UNICODE_GENERAL_CATEGORY_DECIMAL_NUMBER:
        case HB_UNICODE_GENERAL_CATEGORY_LETTER_NUMBER:
        case HB_UNICODE_GENERAL_CATEGORY_OTHER_NUMBER:
            if (const BidiClass letter = classOfLetter(c); letter != L && !(c >= 0x660 && c <= 0x6f9)) return letter;
            return classOfNumber(c, category);
        case HB_UNICODE_GENERAL_CATEGORY_CONNECT_PUNCTUATION:
        case HB_UNICODE_GENERAL_CATEGORY_DASH_PUNCTUATION:
        case HB_UNICODE_GENERAL_CATEGORY_OPEN_PUNCTUATION:
        case HB_UNICODE_GENERAL_CATEGORY_CLOSE_PUNCTUATION:
        case HB_UNICODE_GENERAL_CATEGORY_INITIAL_PUNCTUATION:
        case HB_UNICODE_GENERAL_CATEGORY_FINAL_PUNCTUATION:
        case HB_UNICODE_GENERAL_CATEGORY_OTHER_PUNCTUATION:
        case HB_UNICODE_GENERAL_CATEGORY_CURRENCY_SYMBOL:
        case HB_UNICODE_GENERAL_CATEGORY_MATH_SYMBOL:
        case HB_UNICODE_GENERAL_CATEGORY_MODIFIER_SYMBOL:
        case HB_UNICODE_GENERAL_CATEGORY_OTHER_SYMBOL:
            if (c == 0x66b || c == 0x66c) return AN;
            if (const BidiClass symbol = classOfSymbol(c, category); symbol != ON) return symbol;
            return classOfSign(c);
        case HB_UNICODE_GENERAL_CATEGORY_MODIFIER_LETTER: {
            // Spacing accents are neutral; modifiers that are part of words have a letter's direction.
            const bool accent = (c >= 0x2b9 && c <= 0x2ba) || (c >= 0x2c6 && c <= 0x2cf) || c == 0x2ec || c == 0x374;
            return accent ? ON : classOfLetter(c);
        }
        default:
            return classOfLetter(c);
    }
}

namespace {

bool isIsolate(BidiClass c) { return c == LRI || c == RLI || c == FSI; }
bool isNeutral(BidiClass c) { return c == B || c == S || c == WS || c == ON || isIsolate(c) || c == PDI; }
bool isRemoved(BidiClass c) { return c == LRE || c == LRO || c == RLE || c == RLO || c == PDF || c == BN; }

/// P2, P3: right to left if the first letter outside isolates is. @param toEnd  to the end of an isolate
/// @returns nothing without a letter
std::optional<bool> firstDirection(std::span<const BidiClass> classes, bool toEnd) {
    int depth = 0;
    for (const BidiClass c : classes) {
        if (c == PDI) {
            if (depth == 0 && !toEnd) return {};
            depth = std::max(depth - 1, 0);
        }
        if (isIsolate(c)) ++depth;
        if (depth > 0) continue;
        if (c == L) return false;
        if (c == R || c == AL) return true;
    }
    return {};
}

struct Line {
    std::span<const char32_t> text;
    std::vector<BidiClass> original, classes;
    std::vector<std::uint8_t> levels;
    std::uint8_t base = 0;
};

/// X1 to X8: levels of embeddings, overrides and isolates.
void embed(Line& line) {
    struct Status {
        std::uint8_t level;
        std::optional<BidiClass> override;
        bool isolate;
    };
    constexpr std::uint8_t kMostLevels = 125;
    std::vector<Status> stack{{line.base, {}, false}};
    std::size_t overflowIsolates = 0, overflowEmbeddings = 0, isolates = 0;
    for (std::size_t i = 0; i < line.text.size(); ++i) {
        BidiClass& c = line.classes[i];
        const auto take = [&] {
            line.levels[i] = stack.back().level;
            if (stack.back().override && c != BN) c = *stack.back().override;
        };
        const BidiClass was = c;
        if (isIsolate(was) || was == LRE || was == LRO || was == RLE || was == RLO) {
            bool right = was == RLE || was == RLO || was == RLI;
            if (was == FSI) right = firstDirection(std::span(line.original).subspan(i + 1), false).value_or(false);
            line.levels[i] = stack.back().level;
            if (isIsolate(was)) take();
            const auto next =
                static_cast<std::uint8_t>(right ? (stack.back().level + 1) | 1 : (stack.back().level + 2) & ~1);
            if (next <= kMostLevels && overflowIsolates == 0 && overflowEmbeddings == 0) {
                if (isIsolate(was)) ++isolates;
                stack.push_back({next,
                                 was == LRO   ? std::optional(L)
                                 : was == RLO ? std::optional(R)
                                              : std::nullopt,
                                 isIsolate(was)});
            } else if (isIsolate(was)) {
                ++overflowIsolates;
            } else if (overflowIsolates == 0) {
                ++overflowEmbeddings;
            }
        } else if (was == PDI) {
            if (overflowIsolates > 0) {
                --overflowIsolates;
            } else if (isolates > 0) {
                overflowEmbeddings = 0;
                while (!stack.back().isolate) stack.pop_back();
                stack.pop_back();
                --isolates;
            }
            take();
        } else if (was == PDF) {
            line.levels[i] = stack.back().level;
            if (overflowIsolates > 0) continue;
            if (overflowEmbeddings > 0)
                --overflowEmbeddings;
            else if (!stack.back().isolate && stack.size() > 1)
                stack.pop_back();
        } else if (was == B) {
            line.levels[i] = line.base;
        } else {
            take();
        }
    }
}

/// X10: positions of each isolating run sequence, without the characters that X9 removes.
std::vector<std::vector<std::size_t>> sequences(const Line& line) {
    std::vector<std::vector<std::size_t>> all;
    std::vector<std::size_t> waiting;  // sequences interrupted by an isolate
    std::optional<std::size_t> current;
    std::uint8_t level = 0;
    bool afterIsolate = false;
    for (std::size_t i = 0; i < line.text.size(); ++i) {
        if (isRemoved(line.original[i])) continue;
        if (current && (line.levels[i] != level || afterIsolate)) {
            if (afterIsolate) waiting.push_back(*current);
            current.reset();
        }
        if (!current && line.original[i] == PDI && !waiting.empty()) {
            // The sequence that ends with the isolate's opening continues.
            while (!waiting.empty() && line.levels[all[waiting.back()].back()] != line.levels[i]) waiting.pop_back();
            if (!waiting.empty()) {
                current = waiting.back();
                waiting.pop_back();
            }
        }
        if (!current) {
            current = all.size();
            all.emplace_back();
        }
        all[*current].push_back(i);
        level = line.levels[i];
        afterIsolate = isIsolate(line.original[i]);
    }
    return all;
}

BidiClass strength(BidiClass c) { return c == EN || c == AN || c == R ? R : c; }

/// W1 to W7.
void settleWeak(Line& line, const std::vector<std::size_t>& at, BidiClass before) {
    const auto c = [&](std::size_t k) -> BidiClass& { return line.classes[at[k]]; };
    BidiClass last = before, strong = before;
    for (std::size_t k = 0; k < at.size(); ++k) {
        if (c(k) == NSM) c(k) = isIsolate(last) || last == PDI ? ON : last;
        last = c(k);
        if (c(k) == R || c(k) == L || c(k) == AL) strong = c(k);
        if (c(k) == EN && strong == AL) c(k) = AN;
    }
    for (std::size_t k = 0; k < at.size(); ++k)
        if (c(k) == AL) c(k) = R;
    for (std::size_t k = 1; k + 1 < at.size(); ++k) {
        if (c(k) == ES && c(k - 1) == EN && c(k + 1) == EN) c(k) = EN;
        if (c(k) == CS && c(k - 1) == c(k + 1) && (c(k - 1) == EN || c(k - 1) == AN)) c(k) = c(k - 1);
    }
    for (std::size_t k = 0; k < at.size();) {
        if (c(k) != ET) {
            ++k;
            continue;
        }
        std::size_t end = k;
        while (end < at.size() && c(end) == ET) ++end;
        const bool beside = (k > 0 && c(k - 1) == EN) || (end < at.size() && c(end) == EN);
        for (; k < end; ++k) c(k) = beside ? EN : ON;
    }
    strong = before;
    for (std::size_t k = 0; k < at.size(); ++k) {
        if (c(k) == ES || c(k) == CS) c(k) = ON;
        if (c(k) == R || c(k) == L) strong = c(k);
        if (c(k) == EN && strong == L) c(k) = L;
    }
}

/// N0: both brackets of a pair take the direction of the text between or before them.
void settleBrackets(Line& line, const std::vector<std::size_t>& at, BidiClass before, BidiClass embedding) {
    constexpr std::size_t kMostOpen = 63;
    hb_unicode_funcs_t* const unicode = hb_unicode_funcs_get_default();
    const auto canonical = [](char32_t c) -> char32_t { return c == 0x2329 ? 0x3008 : c == 0x232a ? 0x3009 : c; };
    std::vector<std::pair<char32_t, std::size_t>> open;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t k = 0; k < at.size(); ++k) {
        const char32_t letter = canonical(line.text[at[k]]);
        if (line.classes[at[k]] != ON) continue;
        const auto category = hb_unicode_general_category(unicode, letter);
        const auto mirrored = static_cast<char32_t>(hb_unicode_mirroring(unicode, letter));
        if (mirrored == letter) continue;
        if (category == HB_UNICODE_GENERAL_CATEGORY_OPEN_PUNCTUATION) {
            if (open.size() == kMostOpen) break;
            open.emplace_back(canonical(mirrored), k);
        } else if (category == HB_UNICODE_GENERAL_CATEGORY_CLOSE_PUNCTUATION) {
            const auto found =
                std::find_if(open.rbegin(), open.rend(), [&](const auto& o) { return o.first == letter; });
            if (found == open.rend()) continue;
            pairs.emplace_back(found->second, k);
            open.erase(std::prev(found.base()), open.end());
        }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [from, to] : pairs) {
        bool same = false, other = false;
        for (std::size_t k = from + 1; k < to; ++k) {
            const BidiClass c = strength(line.classes[at[k]]);
            if (c == embedding) same = true;
            if (c != embedding && (c == L || c == R)) other = true;
        }
        if (!same && !other) continue;
        BidiClass chosen = embedding;
        if (!same) {
            BidiClass context = before;
            for (std::size_t k = 0; k < from; ++k)
                if (const BidiClass c = strength(line.classes[at[k]]); c == L || c == R) context = c;
            if (context != embedding) chosen = context;
        }
        for (const std::size_t bracket : {from, to}) {
            line.classes[at[bracket]] = chosen;
            for (std::size_t k = bracket + 1; k < at.size() && line.original[at[k]] == NSM; ++k)
                line.classes[at[k]] = chosen;
        }
    }
}

/// N1, N2: neutrals between letters of one direction take it.
void settleNeutral(Line& line, const std::vector<std::size_t>& at, BidiClass before, BidiClass after,
                   BidiClass embedding) {
    for (std::size_t k = 0; k < at.size();) {
        if (!isNeutral(line.classes[at[k]])) {
            ++k;
            continue;
        }
        std::size_t end = k;
        while (end < at.size() && isNeutral(line.classes[at[end]])) ++end;
        const BidiClass left = k > 0 ? strength(line.classes[at[k - 1]]) : before;
        const BidiClass right = end < at.size() ? strength(line.classes[at[end]]) : after;
        for (; k < end; ++k) line.classes[at[k]] = left == right ? left : embedding;
    }
}

void settle(Line& line) {
    const auto direction = [](std::uint8_t level) { return level % 2 ? R : L; };
    const std::vector<std::uint8_t> explicitly = line.levels;
    for (const std::vector<std::size_t>& at : sequences(line)) {
        const std::uint8_t level = explicitly[at.front()];
        std::uint8_t previous = line.base, next = line.base;
        for (std::size_t i = at.front(); i-- > 0;)
            if (!isRemoved(line.original[i])) {
                previous = explicitly[i];
                break;
            }
        if (!isIsolate(line.original[at.back()]))
            for (std::size_t i = at.back() + 1; i < line.text.size(); ++i)
                if (!isRemoved(line.original[i])) {
                    next = explicitly[i];
                    break;
                }
        const BidiClass before = direction(std::max(level, previous)), after = direction(std::max(level, next));
        settleWeak(line, at, before);
        settleBrackets(line, at, before, direction(level));
        settleNeutral(line, at, before, after, direction(level));
        for (const std::size_t i : at) {  // I1, I2
            const BidiClass c = line.classes[i];
            if (level % 2 == 0)
                line.levels[i] = static_cast<std::uint8_t>(level + (c == R ? 1 : c == AN || c == EN ? 2 : 0));
            else
                line.levels[i] = static_cast<std::uint8_t>(level + (c == R ? 0 : 1));
        }
    }
    // L1: spaces at the end of the line, and separators, have the line's direction.
    bool ending = true;
    for (std::size_t i = line.text.size(); i-- > 0;) {
        const BidiClass c = line.original[i];
        if (c == B || c == S) ending = true;
        if (ending && (c == B || c == S || c == WS || isIsolate(c) || c == PDI))
            line.levels[i] = line.base;
        else if (!isRemoved(c))
            ending = false;
    }
}

}  // namespace

std::vector<DirectedRun> visualRuns(std::span<const char32_t> text) {
    Line line{text, {}, {}, std::vector<std::uint8_t>(text.size()), 0};
    for (const char32_t c : text) line.original.push_back(findBidiClass(c));
    line.classes = line.original;
    line.base = firstDirection(line.original, true).value_or(false) ? 1 : 0;
    embed(line);
    settle(line);
    std::vector<DirectedRun> runs;
    std::vector<std::uint8_t> levels;
    bool gap = true;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const BidiClass c = line.original[i];
        if (isRemoved(c) && c != BN) {
            gap = true;
            continue;
        }
        if (c == BN && i > 0) line.levels[i] = line.levels[i - 1];  // joiners take the level of the preceding character
        if (gap || levels.back() != line.levels[i]) {
            runs.push_back({i, 0, line.levels[i] % 2 == 1});
            levels.push_back(line.levels[i]);
        }
        ++runs.back().count;
        gap = false;
    }
    // L2.
    const int highest = levels.empty() ? 0 : *std::max_element(levels.begin(), levels.end());
    for (int level = highest; level > 0; --level)
        for (std::size_t i = 0; i < runs.size();) {
            std::size_t end = i;
            while (end < runs.size() && levels[end] >= level) ++end;
            std::reverse(runs.begin() + static_cast<std::ptrdiff_t>(i),
                         runs.begin() + static_cast<std::ptrdiff_t>(end));
            std::reverse(levels.begin() + static_cast<std::ptrdiff_t>(i),
                         levels.begin() + static_cast<std::ptrdiff_t>(end));
            i = std::max(end, i + 1);
        }
    return runs;
}

}  // namespace nacre::app
