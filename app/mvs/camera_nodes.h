#pragma once
// Where a scene is seen from: its camera node, or what it focuses on, by Mol*'s rules.

#include <cstdint>
#include <optional>
#include <vector>

#include "app/mvs/scene_parts.h"
#include "engine/scene/scene_guide.h"

namespace nacre::app::mvs {

class CameraNodes {
public:
    void takeCamera(const Node& node, SceneWarnings& warnings);
    /// A focus on some atoms of a structure. @param structure  from 0 @param atoms  of it, ascending
    void takeFocus(const Node& node, std::size_t structure, std::vector<std::uint32_t> atoms);
    /// A focus on all that is drawn.
    void focusAll(const Node& node);
    /// The camera that follows. @param molecule  all structures @param firsts  first atom of each in it
    std::optional<SceneCamera> camera(const Molecule& molecule, const SceneGuide& guide,
                                      const std::vector<std::uint32_t>& firsts, SceneWarnings& warnings) const;

private:
    struct Focus {
        const Node* node = nullptr;
        std::size_t structure = 0;
        std::vector<std::uint32_t> atoms;
        bool all = false;
    };
    std::optional<SceneCamera> camera_;
    std::vector<Focus> focuses_;
};

}  // namespace nacre::app::mvs
