#pragma once
// Which atoms are drawn, in what style and colour: one style and colour for all, then rules in order.

#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/effects.h"
#include "engine/mesh/cartoon.h"
#include "engine/mesh/surface.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/selection/selection.h"
#include "engine/scene/build/contacts.h"
#include "engine/scene/color/color_schemes.h"

namespace nacre {

/// The first three draw atoms. A cartoon replaces its residues' atoms; atoms that it does not draw (ligands, ions)
/// become licorice, or small balls without bonds. A surface is added to the others, but replaces space-filling atoms,
/// which have its size. As the style for all it applies to proteins and nucleic acids; other atoms are drawn as with a
/// cartoon, unless there are only those.
///
/// Lines are bonds of constant width in the picture. A backbone is a tube through alpha carbons or phosphates;
/// carbohydrate draws sugars as symbols (carbohydrates.h). Both leave other atoms as a cartoon does. Ellipsoids draw
/// displacements (atom_ellipsoids.h), with thin sticks.
enum class Style { spacefill, ballAndStick, licorice, cartoon, surface, line, backbone, carbohydrate, ellipsoids };

/// Sugars in addition to a cartoon: as any ligand, as symbols, or as small symbols within their licorice.
enum class Carbohydrates : std::uint8_t { off, on, icon };

/// Bonds whose order is drawn: none, those outside polymers, all.
enum class BondOrders : std::uint8_t { off, ligands, on };
/// The inner line of an aromatic ring: dashes along each bond, or a circle.
enum class AromaticForm : std::uint8_t { dashes, ring };

/// How a surface is drawn: filled, or as lines of constant width in the picture, or as dots.
enum class SurfaceForm : std::uint8_t { solid, mesh, dots };

/// How ellipsoids show their principal axes: by bands along the principal ellipses, or also by an octant that is cut
/// out towards the viewer, as in ORTEP.
enum class EllipsoidForm : std::uint8_t { bands, octants };

/// Sizes of atoms and bonds.
struct Sizes {
    double stick = 0.25;      ///< radius of licorice, Å
    double bond = 0.15;       ///< radius of bonds in ball-and-stick, Å
    double ball = 0.25;       ///< of the van der Waals radius, ball-and-stick
    double tube = 0.3;        ///< radius of backbones, Å
    double probability = 50;  ///< of an atom inside its ellipsoid, %
    friend bool operator==(const Sizes&, const Sizes&) = default;
};

constexpr double kLeastOpacity = 0.01;  ///< less would be invisible

/// One of `--show`, `--hide`, `--color-by`. A later rule overrides an earlier one.
struct Rule {
    enum class Action {
        /// Sets a style, and shows again what an earlier rule hid. Atoms with an atom style keep their cartoon and
        /// surface until these are hidden.
        show,
        hide,
        color
    };
    Action action = Action::show;
    Selection selection;
    Style style = Style::spacefill;         ///< for show
    Coloring coloring;                      ///< for color
    bool on = true;                         ///< false: the rule has no effect
    std::optional<double> opacity = {};     ///< of the shown atoms; empty: the opacity for all
    std::optional<Material> material = {};  ///< of the shown atoms, if opaque; empty: the picture's
    friend bool operator==(const Rule&, const Rule&) = default;
};

/// Whether any rule gives a material.
bool haveMaterials(const std::vector<Rule>& rules);

struct RepresentationOptions {
    std::optional<Style> style = {};  ///< empty: defaultStyle() of the atoms that remain after the rules
    Coloring color = ColorScheme::element;
    std::vector<Rule> rules = {};
    std::string assembly = {};              ///< identifier from the file; empty: no assembly
    AnyPalette palette = {};                ///< for schemes without their own palette, if it is of their kind
    bool ownFrame = false;                  ///< the camera frames this model alone, not all models of its file
    std::optional<glm::dvec3> center = {};  ///< of the scene, Å in the file's frame; empty: of what is drawn
    CartoonOptions cartoon = {};
    SurfaceOptions surface = {};
    /// kLeastOpacity to 1, unless a rule sets one. Atoms: spheres and sticks of every style.
    double cartoonOpacity = 1, surfaceOpacity = 1, atomOpacity = 1;
    bool modelsOcclude = false;  ///< models drawn together occlude each other
    ContactOptions contacts = {};
    std::vector<Coloring> colorFrom = {};  ///< tables: override `color`; rules override them; the last one wins
    Carbohydrates carbohydrates = Carbohydrates::off;
    double sugarScale = 1;    ///< of symbols
    bool sugarColors = true;  ///< colours of the symbols; false: of the sugars' atoms
    double lineWidth = 1.5;   ///< of Style::line, pixels
    Sizes sizes = {};
    SurfaceForm surfaceForm = SurfaceForm::solid;
    bool gaps = true;  ///< dashes where a chain of a cartoon or backbone is broken
    BondOrders bondOrders = BondOrders::ligands;
    AromaticForm aromatic = AromaticForm::dashes;
    EllipsoidForm ellipsoids = EllipsoidForm::bands;
    Style usual = Style::spacefill;  ///< for defaultStyle()
    friend bool operator==(const RepresentationOptions&, const RepresentationOptions&) = default;
};

/// Legend of a colour scheme for some atoms.
struct Legend {
    std::string selection;  ///< "all", or the text of the rule's selection
    std::string scheme;     ///< coloringText()
    std::vector<LegendEntry> entries;
    AnyPalette ramp = {};    ///< palette of the first `stops` entries, which are evenly spaced
    std::size_t stops = 0;   ///< the other entries are classes
    std::string title = {};  ///< the user's wording, with the markup of labels; empty: by the scheme
};

/// Atoms drawn as one kind of mesh.
struct MeshAtoms {
    std::vector<std::uint32_t> atoms;  ///< ascending
    std::vector<std::uint32_t> colors;
    std::vector<std::uint32_t> tints;  ///< as in Appearance
    std::vector<double> opacity;       ///< 1: opaque
};

struct Appearance {
    std::vector<std::uint32_t> atoms;  ///< atoms drawn as atoms, ascending
    Style style = Style::spacefill;    ///< where no rule sets one
    Sizes sizes = {};
    bool cutsOctants = false;   ///< of ellipsoids
    std::vector<Style> styles;  ///< same length as atoms; atom styles and backbone only
    std::vector<std::uint32_t> colors;
    std::vector<std::uint32_t> tints;           ///< same length as atoms: tint of the copy's colour (colors.h); 0: none
    std::vector<double> opacity;                ///< same length as atoms; 1: opaque
    MeshAtoms cartoon, surface, lines, sugars;  ///< lines and sugars have no opacity
    static constexpr std::uint16_t kNoLegend = 0xffff;
    bool anyByCopy() const;
    std::size_t seen = 0;                    ///< atoms drawn in any style
    std::vector<Legend> legends;             ///< of every scheme that is visible somewhere
    std::vector<std::uint16_t> legendIndex;  ///< of each atom of the molecule: index into legends
    std::vector<std::string> warnings;       ///< rules that match nothing, schemes without data in the file
};

/// Rules select among the drawn atoms only: hidden waters and other conformers stay hidden.
/// @param drawn  indices of drawn atoms (drawn_atoms.h), ascending
Appearance makeAppearance(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                          const RepresentationOptions& options);

/// Everything drawn, as spheres: atoms with their style's radius, then atoms of meshes with an approximate radius.
struct SeenBalls {
    std::vector<std::uint32_t> atoms;
    std::vector<glm::dvec4> balls;  ///< of each: centre (Å, in the file's frame) and radius
};
SeenBalls seenBalls(const Molecule& molecule, const Appearance& appearance);

constexpr float kCartoonReach = 2.5f;  ///< largest distance of a cartoon from an atom, Å
/// Radius of an atom's sphere, Å; for cartoons kCartoonReach. Not for ellipsoids (atom_ellipsoids.h).
float drawnRadius(const Atom& atom, Style style, const Sizes& sizes = {});

/// The default style: ball-and-stick for fewer than 100 drawn atoms with bonds, else spacefill, or the given one.
Style defaultStyle(const Molecule& molecule, std::span<const std::uint32_t> drawn, Style usual = Style::spacefill);

}  // namespace nacre
