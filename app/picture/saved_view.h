#pragma once
// A description as a small JSON that the window saves and `nacre render --view` draws. Its keys are those of the
// options that are saved (Option::save), its values what the options take, and some more for what a hand can turn:
//   {"input": "1bna.pdb", "hash": "87642-c3a1...", "model": 1, "style": "licorice", "color": "chain",
//    "rules": [{"show": "ligand=ball-and-stick"}, {"hide": "chain B"}, {"color-by": "chain A=#ff8000", "off": true}],
//    "orientation": [w, x, y, z], "pan": [x, y], "zoom": 1.5, "labels": ["ligand={residue}"],
//    "further-inputs": [{"name": "drug", "input": "b.sdf"}], "fits": [["/drug", "/receptor and resn STI"]], ...}
// `orientation` is a unit quaternion (v = Q (p - C)), `pan` is in Å. Every key may be left out.

#include <string>

#include "app/picture/description.h"

namespace nacre::app {

/// @param name of the file, for messages. @throws Error that names the key
PictureDescription parseSavedView(const std::string& json, const std::string& name);
PictureDescription readSavedView(const std::string& path);
/// The file as it is. @throws Error if it is missing, or larger than a view can be
std::string readViewText(const std::string& path);
std::string savedViewJson(const PictureDescription& view);

/// Sets what a file of a saved view says. What was there already stays: INPUT instead of the view's, and rules, labels
/// and measurements behind the view's. @throws Error
void applySavedView(const std::string& path, PictureDescription& description);

/// What a view names, read as it says; everything else as in `options`.
InputOptions inputOf(const PictureDescription& view, InputOptions options = {});

}  // namespace nacre::app
