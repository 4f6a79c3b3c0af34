#pragma once
// How light and lines show a scene: the same for every pixel, so that nothing but shading and a primitive's hit know of
// it. What is off costs nothing.

#include <array>
#include <limits>

namespace nacre {

/// Light that stays with the viewer. Shares are 1 by default.
struct Light {
    double ambient = 1;    ///< from all around
    double direct = 1;     ///< from over the left shoulder
    double highlight = 1;  ///< 0: no gloss at all
    double gloss = 42;     ///< exponent of the highlight: the larger, the smaller it is
    double occlusion = 1;  ///< how much of the ambient occlusion counts, 0..1
    friend bool operator==(const Light&, const Light&) = default;
};

/// Lines about whatever stands in front of something else.
struct Contours {
    double width = 0;    ///< pixels of the picture; 0: none
    double depth = 1.5;  ///< Å by which depth jumps at a line
    /// 3: all of the width between chains, between copies and about all of it, two thirds between residues of a chain
    /// that are far apart in it, a third where depth jumps within a group.
    int weights = 1;
    std::array<float, 3> color{0, 0, 0};  ///< sRGB-coded
    friend bool operator==(const Contours&, const Contours&) = default;
};

/// Soft rims about whatever stands in front of something, the denser, the farther that lies behind (after QuteMol:
/// Tarini, Cignoni, Montani 2006).
struct Halos {
    double width = 0;                     ///< pixels of the picture; 0: none
    double depth = 12;                    ///< Å behind a primitive at which its halo is densest
    double strength = 0.6;                ///< share of its colour there, 0..1
    std::array<float, 3> color{0, 0, 0};  ///< sRGB-coded
    friend bool operator==(const Halos&, const Halos&) = default;
};

/// The scene fades into the background with depth.
struct Fog {
    enum class Range { off, automatic, given };
    Range range = Range::off;
    double start = 0, end = 0;  ///< Å from the centre, away from the viewer
    double strength = 0.85;     ///< share of the background at the end and beyond, 0..1
    friend bool operator==(const Fog&, const Fog&) = default;
};

/// What lies before `near` or behind `far` is cut away. What the near plane goes through shows a flat cap.
struct Clip {
    enum class Cap { plain, dark, hatched };
    static constexpr double kNone = std::numeric_limits<double>::infinity();
    double near = -kNone, far = kNone;  ///< Å from the centre, away from the viewer
    Cap cap = Cap::plain;
    bool on() const { return near > -kNone || far < kNone; }
    friend bool operator==(const Clip&, const Clip&) = default;
};

/// What stands between a place and the light over the left shoulder takes its light: one depth map a frame.
struct Shadow {
    double strength = 0;  ///< share of the direct light, 0..1; 0: no map is drawn
    friend bool operator==(const Shadow&, const Shadow&) = default;
};

struct Effects {
    Light light;
    Contours contours;
    Halos halos;
    Fog fog;
    Shadow shadow;
    Clip clip;
    friend bool operator==(const Effects&, const Effects&) = default;

    /// Lines and halos that depend on what stands behind.
    bool linesByGroups() const { return contours.width > 0 && contours.weights == 3; }
    bool rims() const { return linesByGroups() || halos.width > 0; }
};

}  // namespace nacre
