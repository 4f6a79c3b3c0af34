#pragma once
// A MolViewSpec scene file: JSON, or an archive. Detected by content, not by name.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/mvs/archive.h"
#include "app/mvs/scene_tree.h"

namespace nacre::app::mvs {

/// Whether bytes are a scene file.
bool isScene(std::string_view bytes);
/// The content of a file if it is a scene; empty if not, or if it cannot be read. Reads other files no further than
/// needed.
std::optional<std::string> readScene(const std::string& path);
/// Whether a file is a scene; reads no further than needed.
bool isSceneFile(const std::string& path);

struct SceneFile {
    std::string name;
    SceneTree tree;
    std::unique_ptr<SceneArchive> archive;  ///< null: only JSON

    /// @throws Error
    SceneFile(const std::string& name, std::string bytes);
};

/// The JSON of a scene. @param bytes  of its file @throws Error
std::string sceneText(const std::string& name, std::string bytes);

/// The content of a scene file. @throws Error if it is no scene, or too large
std::string readSceneBytes(const std::string& path);

}  // namespace nacre::app::mvs
