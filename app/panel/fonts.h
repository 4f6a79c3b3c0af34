#pragma once
// The panel's own font, and those of the system for what it lacks: names of files in Chinese, Arabic, Thai.

#include <imgui.h>

#include <set>
#include <string>
#include <vector>

#include "app/annotation/system_font.h"
#include "app/annotation/visual_text.h"

namespace nacre::app {

/// What texts need that the built-in font has not.
class ForeignGlyphs {
public:
    explicit ForeignGlyphs(FindFont find) : find_(std::move(find)) {}

    /// Takes note of what a text (UTF-8) needs.
    void read(const std::string& text);
    /// Whether read() met something that it had not met before.
    bool news() const { return news_ && find_; }
    /// Looks for the fonts of all that was met. A script is looked for again where more of it is met.
    void find();

    struct Font {
        FontFile file;
        std::vector<char> bytes;
        std::vector<ImWchar> ranges;  ///< as Dear ImGui takes them
    };
    const std::vector<Font>& fonts() const { return fonts_; }
    /// Of what was met, notes what a font with all of them still lacks.
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

/// Adds the fonts to the current context, in the sizes of the scale of text and of sub- and superscripts.
void addPanelFont(float pixelsPerPoint, const std::vector<ForeignGlyphs::Font>& foreign = {});

}  // namespace nacre::app
