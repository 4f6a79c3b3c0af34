#pragma once
// Converts a picture to a MolViewSpec scene, with notes about what the format cannot express.

#include <span>
#include <string>
#include <vector>

#include "app/picture/description.h"
#include "engine/molecule/molecule.h"
#include "engine/scene/build/scene_guide.h"

namespace nacre::app::mvs {

struct WrittenScene {
    std::string json;
    std::vector<std::string> notes;  ///< what the scene cannot express, a sentence each
};

/// @param volumes  the picture's maps @param camera  its camera @param path  of the scene: files that it names are in
/// its folder @throws Error
WrittenScene writeScene(const Molecule& molecule, const PictureDescription& picture,
                        std::span<const SceneVolume> volumes, const SceneCamera& camera, const std::string& path);

/// The address of an INPUT in a scene: that of a database entry, or the file's name relative to the scene's folder.
/// @param path  of the scene @param outside  receives files that are not in its folder
std::string sceneAddress(const std::string& input, const std::string& path, std::vector<std::string>& outside);

}  // namespace nacre::app::mvs
