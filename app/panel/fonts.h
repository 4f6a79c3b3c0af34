#pragma once
// The panel's own font, and system fonts for missing characters: file names in Chinese, Arabic, Thai.

#include <imgui.h>

#include <set>
#include <string>
#include <vector>

#include "app/annotation/system_font.h"
#include "app/annotation/visual_text.h"

namespace nacre::app {

/// Characters that the built-in font lacks.
class ForeignGlyphs {
public:
    explicit ForeignGlyphs(FindFont find) : find_(std::move(find)) {}

    /// Collects the missing characters of a text (UTF-8).
    void read(const std::string& text);
    /// Whether read() found new ones.
    bool news() const { return news_ && find_; }
    /// Finds fonts for all of them. Repeats the search for a script that has new characters.
    void find();

    struct Font {
        FontFile file;
        std::vector<char> bytes;
        std::vector<ImWchar> ranges;  ///< in Dear ImGui's format
    };
    const std::vector<Font>& fonts() const { return fonts_; }
    /// Records characters that a font with all glyphs still lacks.
    void noteMissing(const ImFont& font);
    /// A sentence that names the fonts to install; empty: nothing is missing.
    const std::string& missing() const { return missing_; }

private:
    FindFont find_;
    std::set<char32_t> met_;
    std::vector<Font> fonts_;
    std::string missing_;
    bool news_ = false;
};

/// Adds the fonts to the current context, in the sizes of text and of sub- and superscripts.
void addPanelFont(float pixelsPerPoint, const std::vector<ForeignGlyphs::Font>& foreign = {});

}  // namespace nacre::app
