#include "app/annotation/visual_text.h"

#ifdef NACRE_FRIBIDI
#include <fribidi.h>

#include "app/files/code_points.h"
#endif

namespace nacre::app {

#ifdef NACRE_FRIBIDI
std::string visualText(const std::string& text) {
    // There is no right-to-left character below U+0590.
    bool may = false;
    for (const char c : text) may |= static_cast<unsigned char>(c) >= 0xd6;
    if (!may) return text;
    std::vector<FriBidiChar> logical, visual;
    for (const char32_t c : codePoints(text)) logical.push_back(c);
    visual.resize(logical.size() + 1);
    FriBidiParType direction = FRIBIDI_PAR_ON;
    const auto count = static_cast<FriBidiStrIndex>(logical.size());
    if (!fribidi_log2vis(logical.data(), count, &direction, visual.data(), nullptr, nullptr, nullptr)) return text;
    std::string out(4 * logical.size() + 1, '\0');
    out.resize(
        static_cast<std::size_t>(fribidi_unicode_to_charset(FRIBIDI_CHAR_SET_UTF8, visual.data(), count, out.data())));
    // Joined letters leave zero-width marks.
    for (const char* mark : {"\xef\xbb\xbf", "\xe2\x80\x8e", "\xe2\x80\x8f"})
        for (std::size_t at; (at = out.find(mark)) != std::string::npos;) out.erase(at, 3);
    return out;
}
#else
std::string visualText(const std::string& text) { return text; }
#endif

}  // namespace nacre::app
