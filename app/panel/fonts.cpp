#include "app/panel/fonts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>

#include "app/files/code_points.h"
#include "app/panel/theme.h"

namespace nacre::app {
namespace {

// Latin, Greek, Cyrillic, dashes and primes, raised and lowered digits, arrows, the minus sign.
constexpr ImWchar kGlyphs[] = {0x20,   0x24f,  0x370,  0x52f,  0x2010, 0x2044, 0x2070, 0x209c,
                               0x2190, 0x2193, 0x2212, 0x2212, 0xfffd, 0xfffd, 0};
constexpr float kShares[] = {1.0f, 0.68f, 0.84f, 1.45f};  // text, raised and lowered, captions, headings
constexpr std::size_t kMostForeign = 2000;                // characters; limited by the glyph atlas

bool isOwn(char32_t c) {
    if (c < 0x20) return true;
    for (std::size_t i = 0; kGlyphs[i] != 0; i += 2)
        if (c >= kGlyphs[i] && c <= kGlyphs[i + 1]) return true;
    return false;
}

/// Representative character of a group that fonts cover together: Han, kana and Hangul, Arabic with its joined forms,
/// else 128 consecutive ones.
char32_t findScript(char32_t c) {
    if ((c >= 0x2e80 && c < 0xa000) || (c >= 0xac00 && c < 0xd7b0) || (c >= 0xf900 && c < 0xfb00) ||
        (c >= 0xff00 && c < 0xfff0))
        return 0x4e00;
    if ((c >= 0x600 && c < 0x780) || (c >= 0xfb50 && c < 0xfe00) || (c >= 0xfe70 && c < 0xff00)) return 0x600;
    return c & ~char32_t{127};
}

/// A 16-bit big-endian number in a font; 0 beyond its end.
int wordAt(const std::vector<char>& font, std::size_t at) {
    if (at + 2 > font.size()) return 0;
    return static_cast<unsigned char>(font[at]) << 8 | static_cast<unsigned char>(font[at + 1]);
}
std::size_t offsetAt(const std::vector<char>& font, std::size_t at) {
    return static_cast<std::size_t>(wordAt(font, at)) << 16 | static_cast<std::size_t>(wordAt(font, at + 2));
}

/// From the highest to the lowest point of a font, in em, from its tables head and hhea; 0 if missing.
float readHeight(const std::vector<char>& font, int index) {
    const bool collection = font.size() > 4 && std::string_view(font.data(), 4) == "ttcf";
    const std::size_t start = collection ? offsetAt(font, 12 + 4 * static_cast<std::size_t>(index)) : 0;
    int unitsPerEm = 0, high = 0, low = 0;
    for (int i = 0; i < wordAt(font, start + 4); ++i) {
        const std::size_t record = start + 12 + 16 * static_cast<std::size_t>(i);
        if (record + 16 > font.size()) break;
        const std::string_view tag(&font[record], 4);
        const std::size_t table = offsetAt(font, record + 8);
        if (tag == "head") unitsPerEm = wordAt(font, table + 18);
        if (tag == "hhea") high = wordAt(font, table + 4), low = static_cast<std::int16_t>(wordAt(font, table + 6));
    }
    return unitsPerEm > 0 ? static_cast<float>(high - low) / static_cast<float>(unitsPerEm) : 0;
}

}  // namespace

void ForeignGlyphs::read(const std::string& text) {
    for (const char32_t c : codePoints(text))
        if (!isOwn(c) && c <= IM_UNICODE_CODEPOINT_MAX && met_.size() < kMostForeign) news_ |= met_.insert(c).second;
}

void ForeignGlyphs::find() {
    news_ = false;
    std::map<char32_t, std::vector<char32_t>> scripts;
    for (const char32_t c : met_) scripts[findScript(c)].push_back(c);
    fonts_.clear();
    for (const auto& [script, characters] : scripts) {
        const std::optional<FontFile> file = find_(characters);
        if (!file) continue;
        std::ifstream in(file->path, std::ios::binary);
        Font font{*file, {std::istreambuf_iterator<char>(in), {}}, {}};
        if (font.bytes.empty()) continue;
        for (const char32_t c : characters) font.ranges.insert(font.ranges.end(), 2, static_cast<ImWchar>(c));
        font.ranges.push_back(0);
        fonts_.push_back(std::move(font));
    }
}

void ForeignGlyphs::noteMissing(const ImFont& font) {
    constexpr struct {
        char32_t from, to;
        const char* name;
    } kFonts[] = {{0x590, 0x600, "Noto Sans Hebrew"},     {0x600, 0x780, "Noto Naskh Arabic"},
                  {0x900, 0x980, "Noto Sans Devanagari"}, {0xe00, 0xe80, "Noto Sans Thai"},
                  {0x2e80, 0xfb00, "Noto Sans CJK"},      {0xfb1d, 0xfb50, "Noto Sans Hebrew"},
                  {0xfb50, 0xff00, "Noto Naskh Arabic"},  {0xff00, 0xfff0, "Noto Sans CJK"}};
    std::set<std::string> names;
    for (const char32_t c : met_) {
        if (font.FindGlyphNoFallback(static_cast<ImWchar>(c))) continue;
        const auto known = std::find_if(std::begin(kFonts), std::end(kFonts),
                                        [c](const auto& each) { return c >= each.from && c < each.to; });
        names.insert(known == std::end(kFonts) ? "Noto Sans Symbols 2" : known->name);
    }
    missing_.clear();
    for (const std::string& name : names)
        missing_ += (missing_.empty() ? "Characters are missing: install " : ", ") + name;
    if (!missing_.empty()) missing_ += '.';
}

void addPanelFont(float pixelsPerPoint, const std::vector<ForeignGlyphs::Font>& foreign) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    const std::span<const std::byte> file = fontFile();
    for (const float share : kShares) {
        const float size = std::round(kTextPoints * share * pixelsPerPoint);
        ImFontConfig own;
        own.FontDataOwnedByAtlas = false;  // and does not write to it
        fonts.AddFontFromMemoryTTF(const_cast<std::byte*>(file.data()), static_cast<int>(file.size()), size, &own,
                                   kGlyphs);
        for (const ForeignGlyphs::Font& font : foreign) {
            ImFontConfig merged;
            merged.FontDataOwnedByAtlas = false;
            merged.MergeMode = true;
            merged.FontNo = font.file.index;
            // Dear ImGui's size is from the highest to the lowest point: scales the em to that of the panel's font.
            const float height = readHeight(font.bytes, font.file.index);
            const float whole = height > 0 ? std::round(size * height / kFontSizeOfEm) : size;
            fonts.AddFontFromMemoryTTF(const_cast<char*>(font.bytes.data()), static_cast<int>(font.bytes.size()), whole,
                                       &merged, font.ranges.data());
        }
    }
}

}  // namespace nacre::app
