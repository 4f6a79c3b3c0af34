#pragma once
// A description as a small JSON that the window saves and `nacre render --view` draws. Its keys are the saved options
// (Option::save) with their values, and some more for interactive changes:
//   {"input": "1bna.pdb", "hash": "87642-c3a1...", "model": 1, "style": "licorice", "color": "chain",
//    "rules": [{"show": "ligand=ball-and-stick"}, {"hide": "chain B"}, {"color-by": "chain A=#ff8000", "off": true}],
//    "orientation": [w, x, y, z], "pan": [x, y], "zoom": 1.5, "labels": ["ligand={residue}"],
//    "further-inputs": [{"name": "drug", "input": "b.sdf"}], "fits": [["/drug", "/receptor and resn STI"]], ...}
// `orientation` is a unit quaternion (v = Q (p - C)), `pan` is in Å. `center` is C, `scale` the Å across the shorter
// side: with both, the camera does not depend on the drawn scene. Every key is optional.

#include <cstddef>
#include <string>

#include "app/picture/description.h"

namespace nacre::app {

/// Whether a file is a saved view, a look, or an output of --stats: by its name, or an object most of whose keys are
/// option names. Reads only small JSON objects.
bool isViewFile(const std::string& path);

/// Parses a saved view, or the output of --stats. @param name  of the file, for messages @throws Error with the key
PictureDescription parseSavedView(const std::string& json, const std::string& name);
constexpr std::size_t kMostViewBytes = std::size_t{1} << 20;
/// The file's text. @throws Error if it is missing, empty, or larger than kMostViewBytes
std::string readViewText(const std::string& path);
std::string savedViewJson(const PictureDescription& view);

/// Applies a saved view's file. Values already set stay: INPUT replaces the view's; rules, labels and measurements
/// follow the view's. @throws Error
void applySavedView(const std::string& path, PictureDescription& description);

/// The view's input, read as the view requires; everything else as in `options`.
InputOptions makeInput(const PictureDescription& view, InputOptions options = {});

}  // namespace nacre::app
