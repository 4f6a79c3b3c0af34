#pragma once
// The camera of a scene: its camera node, or its focus, by Mol*'s rules.

#include <cstdint>
#include <optional>
#include <vector>

#include "app/mvs/scene_parts.h"
#include "engine/scene/build/scene_guide.h"

namespace nacre::app::mvs {

class CameraNodes {
public:
    void takeCamera(const Node& node, SceneWarnings& warnings);
    /// A focus on atoms of a structure. @param structure  from 0 @param atoms  of it, ascending
    void takeFocus(const Node& node, std::size_t structure, std::vector<std::uint32_t> atoms);
    /// A focus on the contents of balls. @param balls  centre and radius, Å
    void takeFocus(const Node& node, std::vector<glm::dvec4> balls);
    /// A focus on primitives, which are read later. @returns a number for fillFocus()
    std::size_t takeFocusLater(const Node& node);
    void fillFocus(std::size_t number, std::vector<glm::dvec4> balls) { focuses_[number].balls = std::move(balls); }
    /// A focus on everything drawn.
    void focusAll(const Node& node);
    /// Adds a layer, with the atoms that clips cut away. @param layer  of atoms of all structures
    void addLayer(SceneLayer layer) { layers_.push_back(std::move(layer)); }
    /// Adds balls around everything drawn except structures and maps.
    void addDrawn(const std::vector<glm::dvec4>& balls) { drawn_.insert(drawn_.end(), balls.begin(), balls.end()); }
    /// The resulting camera. @param molecule  all structures @param firsts  first atom of each in it
    std::optional<SceneCamera> camera(const Molecule& molecule, const SceneGuide& guide,
                                      const std::vector<std::uint32_t>& firsts, SceneWarnings& warnings) const;

private:
    struct Focus {
        const Node* node = nullptr;
        std::size_t structure = 0;
        std::vector<std::uint32_t> atoms;
        std::vector<glm::dvec4> balls;
        bool all = false;
    };
    std::optional<SceneCamera> camera_;
    std::vector<Focus> focuses_;
    std::vector<SceneLayer> layers_;
    std::vector<glm::dvec4> drawn_;
};

}  // namespace nacre::app::mvs
