#pragma once
// Converts characters to glyphs by HarfBuzz, which joins, reorders and places letters by the rules of their script.

#include <ft2build.h>

#include <functional>
#include <map>
#include <string>
#include <vector>
#include FT_FREETYPE_H

struct hb_font_t;

namespace nacre::app {

struct ShapedGlyph {
    FT_Face face;
    FT_UInt index;
    double x, y;  ///< ems from the line's left end and its baseline, y up
};

struct ShapedLine {
    std::vector<ShapedGlyph> glyphs;
    double width = 0;  ///< ems
};

/// Not thread-safe. The faces must outlive it.
class Shaper {
public:
    Shaper();
    ~Shaper();
    Shaper(const Shaper&) = delete;

    /// @param findFace  the face that draws a character
    ShapedLine shape(const std::string& text, const std::function<FT_Face(char32_t)>& findFace);

private:
    hb_font_t* makeFont(FT_Face face);
    std::map<FT_Face, hb_font_t*> fonts_;
};

}  // namespace nacre::app
