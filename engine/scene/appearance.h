#pragma once
// Which atoms are seen, in what style, and in what colour: a style and a colour for all, then rules in their order.

#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/mesh/cartoon.h"
#include "engine/mesh/surface.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/selection/selection.h"
#include "engine/scene/color_schemes.h"
#include "engine/scene/contacts.h"

namespace nacre {

/// The first three are of atoms. A cartoon stands in place of its residues' atoms. What it does not draw (ligands,
/// ions) is then licorice, or a small ball where nothing is bonded to it. A surface goes over what is there, but takes
/// the place of space-filling atoms, which reach as far.
enum class Style { spacefill, ballAndStick, licorice, cartoon, surface };

/// Of which bonds the order is seen: none, those of all but polymers, all.
enum class BondOrders : std::uint8_t { off, ligands, on };
/// The inner line of an aromatic ring: dashes along each bond, or a circle.
enum class AromaticForm : std::uint8_t { dashes, ring };

constexpr double kLeastOpacity = 0.01;  ///< of a cartoon or surface; less would not be seen

/// One of `--show`, `--hide`, `--color-by`. A later rule prevails over an earlier one.
struct Rule {
    enum class Action {
        /// Give a style, and bring back what an earlier rule hid. Atoms that get a style of atoms keep their cartoon
        /// and surface, which go only with what is hidden.
        show,
        hide,
        color
    };
    Action action = Action::show;
    Selection selection;
    Style style = Style::spacefill;      ///< of show
    Coloring coloring;                   ///< of color
    bool on = true;                      ///< or it is kept, and says nothing
    std::optional<double> opacity = {};  ///< of a cartoon or surface that is shown; empty: that of all
    friend bool operator==(const Rule&, const Rule&) = default;
};

struct RepresentationOptions {
    std::optional<Style> style;  ///< empty: defaultStyle() of the atoms that the rules leave
    Coloring color = ColorScheme::element;
    std::vector<Rule> rules = {};
    std::string assembly = {};             ///< identifier of one that the file states; empty: its atoms as they are
    Palette palette = Palette::automatic;  ///< of the schemes that have one and name none, where it is of their kind
    bool ownFrame = false;                 ///< the camera is this model's own, not one for all models of its file
    CartoonOptions cartoon = {};
    SurfaceOptions surface = {};
    double cartoonOpacity = 1, surfaceOpacity = 1;  ///< kLeastOpacity to 1, of what no rule gives one
    bool modelsOcclude = false;                     ///< models that are drawn together darken each other
    ContactOptions contacts = {};
    BondOrders bondOrders = BondOrders::ligands;
    AromaticForm aromatic = AromaticForm::dashes;
    friend bool operator==(const RepresentationOptions&, const RepresentationOptions&) = default;
};

/// What the colours of some atoms mean.
struct Legend {
    std::string selection;  ///< "all", or the text of the rule's selection
    std::string scheme;     ///< coloringText()
    std::vector<LegendEntry> entries;
    Palette ramp = Palette::automatic;  ///< along which the first `stops` entries stand, evenly
    std::size_t stops = 0;              ///< the other entries are kinds
};

/// Atoms that are drawn as one kind of mesh.
struct MeshAtoms {
    std::vector<std::uint32_t> atoms;  ///< ascending
    std::vector<std::uint32_t> colors;
    std::vector<std::uint32_t> tints;  ///< as Appearance has them
    std::vector<double> opacity;       ///< 1: it hides what is behind it
};

struct Appearance {
    std::vector<std::uint32_t> atoms;  ///< those that are seen as atoms, ascending
    Style style = Style::spacefill;    ///< of those that no rule gives one
    std::vector<Style> styles;         ///< same length as atoms; of atoms all
    std::vector<std::uint32_t> colors;
    std::vector<std::uint32_t> tints;  ///< same length as atoms: of the colour of its copy (colors.h); 0: it is none
    MeshAtoms cartoon, surface;
    bool anyByCopy() const;
    std::size_t seen = 0;               ///< atoms that are seen in whatever style
    std::vector<Legend> legends;        ///< of every colouring that is seen somewhere
    std::vector<std::string> warnings;  ///< rules that match nothing, schemes that the file has no data for
};

/// Rules choose among the drawn atoms only: waters that are not drawn, or other conformers, stay away.
/// @param drawn  indices of drawn atoms (drawn_atoms.h), ascending
Appearance appearanceOf(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                        const RepresentationOptions& options);

/// All that is seen as balls: atoms in their styles' radii, then those of meshes, which reach about as far.
struct SeenBalls {
    std::vector<std::uint32_t> atoms;
    std::vector<glm::dvec4> balls;  ///< of each: centre (Å, in the file's frame) and radius
};
SeenBalls seenBalls(const Molecule& molecule, const Appearance& appearance);

constexpr float kLicoriceRadius = 0.25f;  ///< Å, of atoms and bonds
constexpr float kCartoonReach = 2.5f;     ///< Å, that a cartoon may stand off an atom
/// Of an atom's sphere, Å; of a cartoon kCartoonReach.
float drawnRadius(Element element, Style style);

/// The style where none is asked for: ball-and-stick under 100 drawn atoms with bonds, else spacefill.
Style defaultStyle(const Molecule& molecule, std::span<const std::uint32_t> drawn);

}  // namespace nacre
