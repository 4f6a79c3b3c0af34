#pragma once
// Light, outlines, fog and clipping of a scene. A disabled effect costs nothing.

#include <array>
#include <limits>
#include <optional>

namespace nacre {

/// How surfaces reflect light (shaders/common/shading.glsl).
enum class Material {
    matte,    ///< no highlight
    plastic,  ///< a white highlight
    metal,    ///< a broad highlight in the surface's colour, and less other light
    glow      ///< emits light, without shadow
};

/// Light that moves with the viewer. Factors are 1 by default.
struct Light {
    Material material = Material::plastic;  ///< where no rule sets one (Representation::ownMaterials)
    double ambient = 1;                     ///< from all directions
    double direct = 1;                      ///< from over the left shoulder
    double highlight = 1;                   ///< brightness; 0: none
    double gloss = 42;                      ///< exponent of the highlight: larger is sharper
    double occlusion = 1;                   ///< strength of ambient occlusion, 0..1
    friend bool operator==(const Light&, const Light&) = default;
};

/// Outlines where depth jumps.
struct Contours {
    double width = 0;    ///< pixels; 0: none
    double depth = 1.5;  ///< least depth jump, Å
    /// 3: full width around chains, copies and the whole; two thirds between residues that are far apart in a chain;
    /// one third at other depth jumps.
    int weights = 1;
    std::array<float, 3> color{0, 0, 0};  ///< sRGB-coded
    friend bool operator==(const Contours&, const Contours&) = default;
};

/// Soft rims around foreground shapes, denser the farther the background lies behind (after QuteMol: Tarini, Cignoni,
/// Montani 2006).
struct Halos {
    double width = 0;                     ///< pixels; 0: none
    double depth = 12;                    ///< distance behind at which a halo is densest, Å
    double strength = 0.6;                ///< opacity there, 0..1
    std::array<float, 3> color{0, 0, 0};  ///< sRGB-coded
    friend bool operator==(const Halos&, const Halos&) = default;
};

/// The scene fades into the background with depth.
struct Fog {
    enum class Range { off, automatic, given };
    Range range = Range::off;
    double start = 0, end = 0;  ///< Å from the centre, away from the viewer
    double strength = 0.85;     ///< share of the background from `end` on, 0..1
    friend bool operator==(const Fog&, const Fog&) = default;
};

/// Clipping planes: cut everything before `near` or behind `far`. Flat caps close the near plane's cuts.
struct Clip {
    enum class Cap { plain, dark, hatched };
    static constexpr double kNone = std::numeric_limits<double>::infinity();
    double near = -kNone, far = kNone;  ///< Å from the centre, away from the viewer
    Cap cap = Cap::plain;
    std::optional<std::array<float, 3>> capColor = {};  ///< sRGB-coded; empty: the atoms' colours
    bool on() const { return near > -kNone || far < kNone; }
    friend bool operator==(const Clip&, const Clip&) = default;
};

/// Cast shadow of the direct light: one depth map per frame.
struct Shadow {
    double strength = 0;  ///< share of the direct light that shadows remove, 0..1; 0: no map is drawn
    friend bool operator==(const Shadow&, const Shadow&) = default;
};

/// Blur before and behind the focus, as through a lens.
struct DepthOfField {
    double strength = 0;          ///< width of a point's blur per distance from the focus, 0..1; 0: all is sharp
    std::optional<double> focus;  ///< Å from the centre, away from the viewer; none: the centre
    friend bool operator==(const DepthOfField&, const DepthOfField&) = default;
};

struct Effects {
    Light light;
    Contours contours;
    Halos halos;
    Fog fog;
    Shadow shadow;
    Clip clip;
    DepthOfField depthOfField;  ///< of pictures, and of windows at rest
    friend bool operator==(const Effects&, const Effects&) = default;

    /// Effects that need the primitive of each pixel.
    bool linesByGroups() const { return contours.width > 0 && contours.weights == 3; }
    bool rims() const { return linesByGroups() || halos.width > 0; }
};

}  // namespace nacre
