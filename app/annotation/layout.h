#pragma once
// Words in a picture: which marks of ink stand where, so that they do not overlap. Knows no font but by its widths, and
// nothing of who draws the marks: painter (files) and panel (window) draw the same.

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/annotation/placed_words.h"
#include "engine/effects.h"
#include "engine/scene/camera.h"

namespace nacre::app {

/// Width of a text, UTF-8, in pixels. @param size  of an em, pixels
using TextWidth = std::function<double(const std::string& text, double size)>;

// All in pixels of the picture, from its top left, y down.

struct TextMark {
    glm::dvec2 at{};  ///< left end of the baseline
    double size = 0;  ///< of an em
    std::string text;
    std::uint32_t color = 0;  ///< packed; 0: that of the words
};
struct LineMark {
    std::vector<glm::dvec2> points;
    double width = 1;
};
struct DiscMark {
    glm::dvec2 at{};
    double radius = 0;
    std::uint32_t color = 0;  ///< packed; 0: that of the words
};
/// A rectangle, its colours from top to bottom.
struct RampMark {
    glm::dvec2 low{}, high{};
    std::vector<std::uint32_t> colors;
};

/// A rectangle of the halo's colour, behind all else, through which the picture shows a little.
struct BackMark {
    glm::dvec2 low{}, high{};
    static constexpr double kStrength = 0.8;
};

struct Marks {
    std::vector<BackMark> backs;
    std::vector<LineMark> lines;  ///< drawn in this order, each kind over the one before
    std::vector<DiscMark> discs;
    std::vector<RampMark> ramps;
    std::vector<TextMark> texts;
    std::uint32_t color = 0xff000000, halo = 0xffffffff;  ///< packed
    double haloWidth = 2;
    std::size_t crowded = 0;  ///< labels that found no room and were left out
};

/// Pixels of an em where none are asked for.
double usualTextSize(std::uint32_t width, std::uint32_t height);

struct Held;

/// Where words stood in the picture before, for those that follow each other: a label then moves with what it names,
/// and goes elsewhere only if it must. Of one and the same list of words.
class WordMemory {
public:
    WordMemory();
    ~WordMemory();
    WordMemory(const WordMemory&) = delete;

    std::vector<Held>& labels();
    std::vector<Held>& measures();

private:
    struct Lists;
    std::unique_ptr<Lists> held_;
};

/// @param size        pixels of an em; 0: usualTextSize()
/// @param color       of the ink, sRGB-coded; empty: against the background, under a halo of the opposite
/// @param background  sRGB-coded, straight alpha
/// @param clip        what it cuts away hides no label
/// @param memory      null: the picture stands alone
Marks layOut(const PlacedWords& words, const View& view, double size, const std::optional<std::array<float, 3>>& color,
             const std::array<float, 4>& background, const TextWidth& widthOf, const Clip& clip = {},
             WordMemory* memory = nullptr);

/// The view with the molecule beside title, legends and scale bar: smaller, and moved, by no more than that takes. As
/// it is where they do not meet; where they leave less than a third of its size, too, and lie over it then.
/// @param balls  what is drawn, as drawnBalls() has it @param zoom  of the view: what goes beyond 1 is left to go over
View besideWords(const View& view, const PlacedWords& words, double size, const std::vector<glm::dvec4>& balls,
                 double zoom, const TextWidth& widthOf);

}  // namespace nacre::app
