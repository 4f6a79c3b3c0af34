#pragma once
// Layout of words in a picture: where each mark of ink goes, without overlaps. Uses only the widths of a font and is
// independent of drawing: painter (files) and panel (window) draw the same marks.

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
#include "engine/scene/view/camera.h"

namespace nacre::app {

/// Width of a text, UTF-8, in pixels. @param size  em size, pixels
using TextWidth = std::function<double(const std::string& text, double size)>;

// All in pixels of the picture, from its top left, y down.

struct TextMark {
    glm::dvec2 at{};  ///< left end of the baseline
    double size = 0;  ///< em size
    std::string text;
    std::uint32_t color = 0;  ///< packed; 0: the words' colour
};
struct LineMark {
    std::vector<glm::dvec2> points;
    double width = 1;
};
struct DiscMark {
    glm::dvec2 at{};
    double radius = 0;
    std::uint32_t color = 0;  ///< packed; 0: the words' colour
    std::uint32_t ring = 0;   ///< packed colour of its border, if the disc hardly differs from the background; 0: none
    double inner() const { return ring ? 0.82 * radius : radius; }
};
/// A convex polygon, with its corners clockwise as seen.
struct ShapeMark {
    std::vector<glm::dvec2> corners;
    std::uint32_t color = 0;  ///< packed
};
/// A rectangle with colours from top to bottom.
struct RampMark {
    glm::dvec2 low{}, high{};
    std::vector<std::uint32_t> colors;
};

/// A translucent rectangle of the halo's colour behind everything else.
struct BackMark {
    glm::dvec2 low{}, high{};
    static constexpr double kStrength = 0.8;
};

/// A translucent background of a label, and the wedge from its point: convex polygons that share edges.
struct PlateMark {
    std::vector<std::vector<glm::dvec2>> parts;
    std::uint32_t color = 0;  ///< packed
    static constexpr double kStrength = 0.5;
};

struct Marks {
    std::vector<PlateMark> plates;  ///< behind everything else, farther ones first
    std::vector<BackMark> backs;
    std::vector<LineMark> lines;  ///< drawn in this order, each kind over the previous
    std::vector<ShapeMark> shapes;
    std::vector<DiscMark> discs;
    std::vector<RampMark> ramps;
    std::vector<TextMark> texts;
    std::uint32_t color = 0xff000000, halo = 0xffffffff;  ///< packed
    double haloWidth = 2;
    std::size_t crowded = 0;  ///< labels left out for lack of space
};

/// Default em size, pixels.
double usualTextSize(std::uint32_t width, std::uint32_t height);

struct Held;

/// Positions of words in the previous picture of a sequence. A label moves with its atom, and changes sides only if it
/// must. For one fixed list of words.
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

/// @param size        em size, pixels; 0: usualTextSize()
/// @param color       of the ink, sRGB-coded; empty: contrasts with the background, with a halo of the opposite
/// @param background  sRGB-coded, straight alpha
/// @param clip        atoms cut away by clipping planes hide no label
/// @param memory      null: a single picture
Marks layOut(const PlacedWords& words, const View& view, double size, const std::optional<std::array<float, 3>>& color,
             const std::array<float, 4>& background, const TextWidth& measureWidth, const Clip& clip = {},
             WordMemory* memory = nullptr);

/// Shrinks and shifts the view as little as needed to keep the molecule clear of title, legends, scale bar and axes.
/// Unchanged if they do not overlap, or if the molecule would shrink below a third; then they overlap.
/// @param balls  the scene, from drawnBalls() @param zoom  of the view: parts beyond zoom 1 may overlap
View besideWords(const View& view, const PlacedWords& words, double size, const std::vector<glm::dvec4>& balls,
                 double zoom, const TextWidth& measureWidth);

}  // namespace nacre::app
