#pragma once
// All that a picture depends on besides its size, as a small JSON that viewer and `nacre render --view` share. Its keys
// are the names of the options of `nacre render`, its values what those take, and two more for what a hand can turn:
//   {"input": "1bna.pdb", "hash": "87642-c3a1...", "format": "pdb", "model": 1, "camera": "all",
//    "occlusion-models": "own", "assembly": "1", "style": "licorice", "color": "chain",
//    "rules": [{"show": "ligand=ball-and-stick"}, {"hide": "chain B"}, {"color-by": "chain A=#ff8000"}],
//    "water": "hide", "hydrogens": "show", "projection": "ortho", "fov": 30, "zoom": 1.5,
//    "orientation": [w, x, y, z], "pan": [x, y], "background": "white", "lighting": "on", "occlusion": 128}
// "uncover": a selection that is to be seen whole from there,
// and those of app/picture/effect_options.h, as they differ from the default.
// and, of several molecules: "name": "receptor", "further-inputs": [{"name": "drug", "input": "b.sdf", "hash": "..."}],
//   "fits": [["/drug", "/receptor and resn STI"]]
// and, where atoms move: "trajectory": "md.xtc", "trajectory-hash": ..., "frame": 7, "whole": "on", "fit-frames":
// "backbone", "smooth": 5 and, where there are words: "labels": ["ligand={residue}"], "measures": ["78,92"], "title":
// "B-DNA",
//   "scale-bar": "nm", "legend": "on", "text-size": 24, "text-color": "#202020"; "palette": "muted".
// `orientation` is a unit quaternion (v = Q (p - C)), `pan` is in Å. Every key may be left out.

#include <array>
#include <string>

#include "app/picture/input_options.h"
#include "app/picture/words.h"
#include "engine/effects.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre::app {

struct SavedView {
    std::string input;             ///< empty: none
    std::string hash;              ///< of the input's file when the view was saved; see fileHash(). Empty: not known
    std::optional<Format> format;  ///< empty: by content
    int model = 1;
    TrajectoryOptions trajectory;
    // Several molecules, as those of InputOptions. Their names stand for them in all selections.
    std::string name;
    std::vector<FurtherInput> further;
    std::vector<FitOptions> fits;
    DrawnAtomsOptions drawn;
    RepresentationOptions look;
    Camera camera;
    std::optional<Selection> uncover;  ///< what hides it from the camera is left out
    Words words;
    std::array<float, 4> background{1, 1, 1, 1};  ///< sRGB-coded, straight alpha
    bool lighting = true;
    Effects effects;
    int occlusionDirections = 128;  ///< 0: off
};

/// @param name of the file, for messages. @throws Error that names the key
SavedView parseSavedView(const std::string& json, const std::string& name);
SavedView readSavedView(const std::string& path);
/// The file as it is. @throws Error if it is missing, or larger than a view can be
std::string readViewText(const std::string& path);
/// One key of the JSON, its value as an option has it. @throws std::invalid_argument, Error
void setViewKey(const std::string& key, const std::string& value, SavedView& view);
std::string savedViewJson(const SavedView& view);

/// What a view names, read as it says; everything else as in `options`.
InputOptions inputOf(const SavedView& view, InputOptions options = {});
}  // namespace nacre::app
