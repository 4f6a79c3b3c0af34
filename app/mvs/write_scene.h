#pragma once
// A picture as a MolViewSpec scene: what the format can say of it, and a note of what it cannot.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/picture/description.h"
#include "engine/molecule/residue_facts.h"
#include "engine/scene/scene_guide.h"

namespace nacre::app::mvs {

struct WrittenScene {
    std::string json;
    std::vector<std::string> notes;  ///< what the scene does not say, a sentence each
};

/// @param layers  what is drawn of the molecule, by style (scene_layers.h)
/// @param camera  from where it is seen; empty: the scene states none
WrittenScene writeScene(const ResidueFacts& facts, const PictureDescription& picture,
                        std::span<const SceneLayer> layers, const std::optional<SceneCamera>& camera);

/// The address that a scene names for an INPUT: that of a database entry, or the file's name.
std::string addressOf(const std::string& input);

}  // namespace nacre::app::mvs
