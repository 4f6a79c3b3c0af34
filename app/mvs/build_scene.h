#pragma once
// From the tree of a MolViewSpec scene to one molecule with a guide (scene_guide.h): its structures joined, each node
// done as far as Nacre can. What it cannot do becomes a warning that names the node's place.

#include <functional>
#include <optional>
#include <string>

#include "app/mvs/scene_tree.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre::app::mvs {

struct SceneSources {
    /// The bytes of what a node names, as they were fetched. @throws Error
    std::function<std::string(const std::string& uri)> fetch;
    ReadOptions reading;           ///< its limits are those of all structures together, and of all maps
    std::function<void()> onStep;  ///< called before each node; ends the scene by throwing; may be empty
};

constexpr std::size_t kMostFiles = 1000;  ///< that a scene names
constexpr std::size_t kMostStructures = 1000;
constexpr std::size_t kMostLayers = 10'000;
/// Atoms of all representations together, and text that is parsed, as multiples of what one file may have.
constexpr std::size_t kMostTimes = 16;

/// @param snapshot  from 0 @param name  of the file, for messages
/// @param seconds  of the snapshot's animation; empty: as the snapshot is without it
/// @throws Error
Molecule buildScene(const SceneTree& tree, std::size_t snapshot, const std::string& name, const SceneSources& sources,
                    std::optional<double> seconds = {});

}  // namespace nacre::app::mvs
