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
/// The whole of a file if it is one; empty if not, or if it cannot be read. What is none is read no further than needed
/// to tell.
std::optional<std::string> readScene(const std::string& path);
/// Whether a file is one, read no further than needed to tell.
bool isSceneFile(const std::string& path);

struct SceneFile {
    std::string name;
    SceneTree tree;
    std::unique_ptr<SceneArchive> archive;  ///< null: it is JSON alone

    /// @throws Error
    SceneFile(const std::string& name, std::string bytes);
};

/// The JSON of a scene. @param bytes  of its file @throws Error
std::string sceneText(const std::string& name, std::string bytes);

/// The whole of a file. @throws Error if it is no scene, or is larger than one may be
std::string readSceneBytes(const std::string& path);

}  // namespace nacre::app::mvs
