#pragma once
// A MolViewSpec scene as it comes: JSON, or an archive. Content decides, not the name.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/mvs/archive.h"
#include "app/mvs/scene_tree.h"

namespace nacre::app::mvs {

/// Whether bytes are a scene. @param whole  they are all of the file
bool isScene(std::string_view bytes);
/// The whole of a file if it is one; empty if not, or if it cannot be read. Little is read of what begins otherwise.
std::optional<std::string> readScene(const std::string& path);
/// Whether a file is one. Archives are not read.
bool isSceneFile(const std::string& path);

struct SceneFile {
    std::string name;
    SceneTree tree;
    std::unique_ptr<SceneArchive> archive;  ///< null: it is JSON alone

    /// @throws Error
    SceneFile(const std::string& name, std::string bytes);
};

/// The whole of a file. @throws Error if it cannot be read or is larger than a scene may be
std::string readSceneBytes(const std::string& path);

}  // namespace nacre::app::mvs
