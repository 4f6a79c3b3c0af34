#pragma once
// Which atoms are seen, in what style, and in what colour: a style and a colour for all, then rules in their order.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"
#include "engine/molecule/selection/selection.h"
#include "engine/scene/color_schemes.h"

namespace nacre {

enum class Style { spacefill, ballAndStick, licorice };

/// One of `--show`, `--hide`, `--color-by`. A later rule prevails over an earlier one.
struct Rule {
    enum class Action {
        show,  ///< give a style, and bring back what an earlier rule hid
        hide,
        color
    };
    Action action = Action::show;
    Selection selection;
    Style style = Style::spacefill;  ///< of show
    Coloring coloring;               ///< of color
    friend bool operator==(const Rule&, const Rule&) = default;
};

struct RepresentationOptions {
    std::optional<Style> style;  ///< empty: defaultStyle() of the atoms that the rules leave
    Coloring color = ColorScheme::element;
    std::vector<Rule> rules = {};
    std::string assembly = {};             ///< identifier of one that the file states; empty: its atoms as they are
    Palette palette = Palette::automatic;  ///< of the schemes that have one and name none, where it is of their kind
    bool ownFrame = false;                 ///< the camera is this model's own, not one for all models of its file
    bool modelsOcclude = false;            ///< models that are drawn together darken each other
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

struct Appearance {
    std::vector<std::uint32_t> atoms;  ///< those that are seen, ascending
    Style style = Style::spacefill;    ///< of those that no rule gives one
    std::vector<Style> styles;         ///< same length as atoms
    std::vector<std::uint32_t> colors;
    std::vector<bool> byCopy;           ///< same length as atoms: its colour is that of its copy
    std::vector<Legend> legends;        ///< of every colouring that is seen somewhere
    std::vector<std::string> warnings;  ///< rules that match nothing, schemes that the file has no data for
};

/// Rules choose among the drawn atoms only: waters that are not drawn, or other conformers, stay away.
/// @param drawn  indices of drawn atoms (drawn_atoms.h), ascending
Appearance appearanceOf(const Molecule& molecule, std::span<const std::uint32_t> drawn,
                        const RepresentationOptions& options);

constexpr float kLicoriceRadius = 0.25f;  ///< Å, of atoms and bonds
/// Of an atom's sphere, Å.
float drawnRadius(Element element, Style style);

/// The style where none is asked for: ball-and-stick under 100 drawn atoms with bonds, else spacefill.
Style defaultStyle(const Molecule& molecule, std::span<const std::uint32_t> drawn);

}  // namespace nacre
