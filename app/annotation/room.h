#pragma once
// Free space for words in a picture: taken areas, drawn words, and positions for the next text. Internal to
// word_layout.cpp and word_legend.cpp.

#include <utility>

#include "app/annotation/layout.h"

namespace nacre::app {

// In em of the font (DejaVu Sans): extent above and below the baseline.
constexpr double kRise = 0.76, kDrop = 0.24, kMiddle = 0.36;
constexpr double kSmall = 0.68, kRaised = 0.36, kLowered = 0.16;  // sub- and superscripts

struct Area {
    glm::dvec2 low{}, high{};
    bool overlaps(const Area& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
    bool within(const Area& other) const {
        return low.x >= other.low.x && low.y >= other.low.y && high.x <= other.high.x && high.y <= other.high.y;
    }
    bool holds(const glm::dvec2& p) const { return p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y; }
    Area grown(double by) const { return {low - by, high + by}; }
    glm::dvec2 middle() const { return (low + high) / 2.0; }
    glm::dvec2 nearest(const glm::dvec2& p) const { return glm::clamp(p, low, high); }
};

/// Position of a word in the previous picture.
struct Held {
    bool placed = false;
    glm::dvec2 offset{};   ///< of its centre from its anchor
    bool shown = false;    ///< was not hidden
    std::size_t rank = 0;  ///< in order of placement
};

struct Room {
    Room(const View& view, double size, const TextWidth& measureWidth);

    struct Seen {
        glm::dvec2 at{};
        double z = 0, scale = 1;  ///< pixels per Å there
        bool inPicture = false;
    };
    Seen seen(const glm::dvec3& place) const;

    double widthOfRuns(const std::string& text, double em) const;
    /// Places a text and takes its area. @param at  left end of its baseline
    void put(const std::string& text, glm::dvec2 at, double em);
    bool isFree(const Area& area) const;
    /// Finds a position for a text near an anchor: the first of `wishes` (offsets of its centre) if free, else farther
    /// and farther away. Moving from its previous position has a cost: it stays, or moves step by step.
    /// @param held  in: the previous position; out: the new one @returns whether there is one
    bool place(const std::string& text, const glm::dvec2& anchor, const std::vector<glm::dvec2>& wishes,
               const std::vector<glm::dvec2>& avoided, Held& held);
    double driftCost(const Area& area, const glm::dvec2& anchor, bool beside) const;
    /// Draws a leader line to a text.
    void lead(const glm::dvec2& anchor, const glm::dvec2& to);
    void dashed(const std::vector<glm::dvec2>& points);

    const View& view;
    double size, margin, titleDepth = 0;
    std::uint32_t ink = 0;  ///< colour of new marks, as in TextMark
    const TextWidth& measureWidth;
    Area frame;
    std::vector<Area> taken;
    std::vector<std::pair<glm::dvec2, glm::dvec2>> leaders;
    Marks marks;
};

/// Title, scale bar, legends and axes, whose positions do not depend on the molecule.
void layBlocks(Room& room, const PlacedWords& words);

/// In at most three columns from the right edge.
void layLegends(Room& room, const std::vector<Legend>& legends);

/// In the lower left corner, rotated with the view; they take the same area from all sides.
void layAxes(Room& room, const std::vector<PlacedAxis>& axes);

}  // namespace nacre::app
