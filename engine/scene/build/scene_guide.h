#pragma once
// How a scene file draws its molecules: several representations of the same atoms, each with its own colours; copies;
// labels; camera and background. A plain value that accompanies its molecule.

#include <array>
#include <cstdint>
#include <functional>
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

/// Text of some atoms.
struct SceneNote {
    std::vector<std::uint32_t> atoms;  ///< ascending
    std::string text;                  ///< plain
};

/// A camera that looks at a ball, in perspective; its angle spans the picture's height.
struct SceneCamera {
    glm::dvec3 target{}, direction{0, 0, -1}, up{0, 1, 0};  ///< Å, in the file's frame; directions of any length
    double radius = 1;    ///< Å; parts farther from the target along the view are cut away
    double distance = 0;  ///< Å from the eye to the target; 0: the ball fills the picture
    double nearest = 0;   ///< Å from the eye to the nearest visible point; 0: 5, or less in a small scene
    double fovDegrees = 45;
};

/// A density map in a scene, over the extent of its file: a contour, or a slice of its grid.
struct SceneVolume {
    std::shared_ptr<const DensityMap> map;
    double level = 0;  ///< of the contour, in the map's unit; negative: encloses lower values
    bool faces = true, wires = false;
    int axis = -1;                     ///< normal to the slice: 0, 1, 2; -1: a contour
    double place = 0;                  ///< of the slice along the axis, 0 to 1
    std::optional<double> least = {};  ///< of the slice: parts with lower values are omitted
    std::uint32_t color =
        0xffffffffu;  ///< packed as in colors.h; a slice is black at the least value, this at the largest
    double opacity = 1;
    Bounds ball;                                       ///< around the map, Å
    std::function<bool(const glm::dvec3&)> cuts = {};  ///< whether a place is left out; empty: none is
};

struct SceneGuide {
    std::vector<SceneLayer> layers;
    /// Copies of residues: each is drawn at all transforms of its list. Empty: once, where its atoms are.
    std::vector<glm::dmat4x3> transforms;           ///< in the file's frame, rigid, all different
    std::vector<std::vector<std::uint32_t>> lists;  ///< of transforms, ascending, all different
    std::vector<std::uint32_t> listOfResidue;       ///< by residue
    std::vector<SceneNote> tooltips;
    Primitives primitives;  ///< includes labels of atoms
    std::vector<SceneVolume> volumes;
    std::optional<SceneCamera> camera;
    std::optional<std::array<float, 4>> background;  ///< sRGB-coded, straight alpha
    std::string title;                               ///< plain; empty: none
    std::vector<std::string> warnings;               ///< of the scene's nodes, a sentence each
};

}  // namespace nacre
