#pragma once
// How a scene file has its molecules drawn: several representations of the same atoms, each in colours of its own;
// copies; labels; camera and background. A plain value that goes with the molecule it was written for.

#include <array>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/build/appearance.h"
#include "engine/scene/build/primitives.h"
#include "engine/scene/view/bounds.h"
#include "engine/volume/density_map.h"

namespace nacre {

/// Some atoms in one style. The same atoms may be in several layers.
struct SceneLayer {
    Style style = Style::cartoon;
    std::vector<std::uint32_t> atoms;              ///< indices into Molecule::atoms, ascending
    std::vector<std::uint32_t> colors;             ///< same length: packed as in colors.h
    std::vector<float> opacity;                    ///< same length, 0 to 1; empty: opaque
    float atomScale = 1, bondScale = 1;            ///< of the style's radii
    float ballRadius = 0;                          ///< Å, of every atom; 0: by the style
    float (*radius)(Element) = vanDerWaalsRadius;  ///< of Style::spacefill
    CartoonOptions cartoon;                        ///< of Style::cartoon
    SurfaceOptions surface;                        ///< of Style::surface
    bool ownColors = false;                        ///< of Style::carbohydrate: `colors` instead of the symbols' colours
};

/// Text that some atoms have.
struct SceneNote {
    std::vector<std::uint32_t> atoms;  ///< ascending
    std::string text;                  ///< plain
};

/// A camera that looks at a ball: perspective, with an angle across the picture's height.
struct SceneCamera {
    glm::dvec3 target{}, direction{0, 0, -1}, up{0, 1, 0};  ///< Å, in the file's frame; directions of any length
    double radius = 1;    ///< Å: what is farther from the target along the view is cut away
    double distance = 0;  ///< Å from the eye to the target; 0: the ball fills the picture
    double nearest = 0;   ///< Å from the eye to what is seen next to it; 0: 5, or less in a small scene
    double fovDegrees = 45;
};

/// A density map as a scene shows it, as far as its file reaches: a contour, or a slice of its grid.
struct SceneVolume {
    std::shared_ptr<const DensityMap> map;
    double level = 0;  ///< of the contour, in the map's unit; a negative one encloses lower values
    bool faces = true, wires = false;
    int axis = -1;                     ///< across which the slice lies: 0, 1, 2; -1: a contour
    double place = 0;                  ///< of the slice along it, 0 to 1
    std::optional<double> least = {};  ///< of the slice: lower values are left out
    std::uint32_t color =
        0xffffffffu;  ///< packed as in colors.h; a slice is black at the least value, this at the largest
    double opacity = 1;
    Bounds ball;  ///< about it, Å
};

struct SceneGuide {
    std::vector<SceneLayer> layers;
    /// Where residues stand: each at all transforms of its list. Empty: once, where its atoms are.
    std::vector<glm::dmat4x3> transforms;           ///< in the file's frame, rigid, no two the same
    std::vector<std::vector<std::uint32_t>> lists;  ///< of transforms, ascending, no two the same
    std::vector<std::uint32_t> listOfResidue;       ///< by residue
    std::vector<SceneNote> tooltips;
    Primitives primitives;  ///< labels of atoms, too
    std::vector<SceneVolume> volumes;
    std::optional<SceneCamera> camera;
    std::optional<std::array<float, 4>> background;  ///< sRGB-coded, straight alpha
    std::string title;                               ///< plain; empty: none
    std::vector<std::string> warnings;               ///< of the scene's nodes, a sentence each
};

}  // namespace nacre
