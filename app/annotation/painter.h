#pragma once
// Draws the marks of word_layout.h into pictures with FreeType: glyph outlines and all other shapes by one rasteriser,
// at any size.

#include <memory>
#include <string>
#include <vector>

#include "app/annotation/layout.h"
#include "app/annotation/system_font.h"
#include "engine/results.h"

namespace nacre::app {

/// Not thread-safe.
class WordPainter {
public:
    /// @param find  finds a font for characters that the built-in one lacks
    /// @throws Error if the built-in font cannot be read
    explicit WordPainter(FindFont find = systemFontWith);
    ~WordPainter();
    WordPainter(const WordPainter&) = delete;

    /// Pixels; a character that no font has is as wide as its box.
    double measureWidth(const std::string& text, double size) const;

    /// Draws the part of the marks in some rows of a picture.
    /// @param rgba   linear light, premultiplied; 4 per pixel; `rows` rows of `width` pixels
    /// @param first  picture row at the start of `rgba`
    void paint(const Marks& marks, float* rgba, std::uint32_t width, std::uint32_t first, std::uint32_t rows) const;

    /// layOut() with the widths of this font.
    Marks layOut(const PlacedWords& words, const View& view, double size,
                 const std::optional<std::array<float, 3>>& color, const std::array<float, 4>& background,
                 const Clip& clip = {}, WordMemory* memory = nullptr) const;

    /// besideWords() with the widths of this font.
    View besideWords(const View& view, const PlacedWords& words, double size, const std::vector<glm::dvec4>& balls,
                     double zoom) const;

    /// Warnings about marks laid out here: labels without space, and characters that no font has.
    std::vector<std::string> listWarnings(const Marks& marks) const;

    /// Lays out words over a whole picture, and draws them. @returns listWarnings() its marks
    std::vector<std::string> paint(const PlacedWords& words, const View& view, double size,
                                   const std::optional<std::array<float, 3>>& color,
                                   const std::array<float, 4>& background, Picture& picture, const Clip& clip = {},
                                   WordMemory* memory = nullptr) const;

private:
    struct Face;
    std::unique_ptr<Face> face_;
};

}  // namespace nacre::app
