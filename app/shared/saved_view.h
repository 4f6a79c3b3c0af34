#pragma once
// All that a picture depends on besides its size, as a small JSON that viewer and `nacre render --view` share. Its keys
// are the names of the options of `nacre render`, its values what those take, and two more for what a hand can turn:
//   {"input": "1bna.pdb", "format": "pdb", "model": 1, "assembly": "1", "style": "licorice", "color": "chain",
//    "rules": [{"show": "ligand=ball-and-stick"}, {"hide": "chain B"}, {"color-by": "chain A=#ff8000"}],
//    "water": "hide", "hydrogens": "show", "projection": "ortho", "fov": 30, "zoom": 1.5,
//    "orientation": [w, x, y, z], "pan": [x, y], "background": "white", "lighting": "on", "occlusion": 128}
// `orientation` is a unit quaternion (v = Q (p - C)), `pan` is in Å. Every key may be left out.

#include <string>
#include <utility>
#include <vector>

#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre::app {

struct SavedView {
    std::string input, format;  ///< empty: none, by content
    int model = 1;
    std::string assembly;                                    ///< empty: the file's atoms as they are
    std::string style, color = "element";                    ///< style: empty means by size
    std::vector<std::pair<std::string, std::string>> rules;  ///< option without dashes, value
    DrawnAtomsOptions drawn;
    Camera camera;
    std::string background = "white";
    bool lighting = true;
    int occlusionDirections = 128;  ///< 0: off
};

/// @param name of the file, for messages. @throws Error that names the key
SavedView parseSavedView(const std::string& json, const std::string& name);
SavedView readSavedView(const std::string& path);
std::string savedViewJson(const SavedView& view);

/// Style, colours and rules as the scene takes them. @throws std::invalid_argument or Error if a text is none
RepresentationOptions lookOf(const SavedView& view);

}  // namespace nacre::app
