#pragma once
// MolViewSpec scenes as INPUT: what they name comes from their archive, their folder, a map, the cache or the network.

#include <functional>
#include <string>
#include <vector>

#include "app/picture/input_options.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre::app {

/// The molecule of a scene, with its guide. Files at addresses in the scene are downloaded only if that is allowed;
/// files must stand in its folder. @param bytes  of the scene's file @throws Error
Molecule loadScene(const InputOptions& input, std::string bytes, const ReadOptions& reading,
                   const std::function<void(double)>& onDownload = {});

/// How long a snapshot is to be seen in a movie, seconds: at rest, and on the way to the next.
struct SnapshotTimes {
    double linger = 0, transition = 0;
};
/// The snapshots of a scene's file. @throws Error if it is no scene
std::vector<SnapshotTimes> snapshotsOf(const std::string& path);

}  // namespace nacre::app
