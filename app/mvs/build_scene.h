#pragma once
// Converts the tree of a MolViewSpec scene to one molecule with a guide (scene_guide.h): joins its structures, and
// applies each node as far as Nacre can. Each unsupported feature gives a warning with the node's path.

#include <functional>
#include <optional>
#include <string>

#include "app/mvs/scene_tree.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre::app::mvs {

struct SceneSources {
    /// Fetches the file that a node names. @throws Error
    std::function<std::string(const std::string& uri)> fetch;
    ReadOptions reading;           ///< its limits apply to all structures together, and to all maps
    std::function<void()> onStep;  ///< called before each node; ends the scene by throwing; may be empty
};

constexpr std::size_t kMostFiles = 1000;  ///< named in a scene
constexpr std::size_t kMostStructures = 1000;
constexpr std::size_t kMostLayers = 10'000;
constexpr std::size_t kMostCopies = 20'000;
/// Maximum of atoms in all representations together, and of parsed text, as multiples of the limits for one file.
constexpr std::size_t kMostTimes = 16;

/// @param snapshot  from 0 @param name  of the file, for messages
/// @param seconds  of the snapshot's animation; empty: the snapshot without it
/// @throws Error
Molecule buildScene(const SceneTree& tree, std::size_t snapshot, const std::string& name, const SceneSources& sources,
                    std::optional<double> seconds = {});

}  // namespace nacre::app::mvs
