#pragma once
// Named looks: matching light, outlines, fog, background and colours. A look is data: options and values in the format
// of saved views, with defaults for the others. Contents and camera are never part of a look.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/picture/description.h"

namespace nacre::app {

struct Look {
    std::string name, about;
    std::vector<std::pair<std::string, std::string>> options;  ///< names without dashes, and their values
};

/// In the order of sheets and menus; the first is the default.
std::span<const Look> looks();

/// A look by name, or from a JSON file of options; a saved view also works, without its other keys.
/// @throws std::invalid_argument, Error
Look readLook(const std::string& nameOrFile);

/// As above from such a file's text. @param name  of the file @throws Error
Look lookFromText(const std::string& json, const std::string& name);

/// The look of a file that contains nothing else; empty for other files. @throws Error
std::optional<Look> lookAlone(const std::string& path);

/// Replaces a view's look. Colours stay unless the look sets them.
void applyLook(const Look& look, PictureDescription& view);

/// The look of a view, in the format of readLook().
std::string lookJson(const PictureDescription& view);
std::string lookJson(const Look& look);

constexpr double kPocketReach = 4;  ///< Å: residues with an atom this close form the pocket

/// Shows the ligand and the residues around it as sticks, their interactions, labels of the residues and a faint
/// cartoon, with the camera on the side that shows most of the ligand. Existing rules and labels come after these.
/// @throws Error as parseSelection()
void applyPocket(std::string_view ligand, PictureDescription& d);

/// Shows two sides in two colours, the residues where they touch as sticks, and the interactions between them, with the
/// camera beside the interface: the first side on the left. Other chains are hidden. Existing rules come after these.
/// @param sides  two chains or selections, separated by a comma @throws Error as parseSelection(),
/// std::invalid_argument
void applyInterface(std::string_view sides, PictureDescription& d);

}  // namespace nacre::app
