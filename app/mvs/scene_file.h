#pragma once
// A MolViewSpec scene as it comes: JSON, or an archive. Content decides, not the name.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/mvs/scene_tree.h"

namespace nacre::app::mvs {

/// Whether bytes begin as a zip does.
bool looksLikeArchive(std::string_view bytes);

/// Entries are bounded before memory is taken: 10,000 of them, 512 MiB each, 100 times their compressed size beyond a
/// mebibyte. Names that lead out of the archive are refused.
class SceneArchive {
public:
    /// @param name  of the file, for messages @throws Error
    SceneArchive(std::string name, std::string bytes);
    ~SceneArchive();
    SceneArchive(const SceneArchive&) = delete;

    bool holds(const std::string& entry) const;
    /// @throws Error
    std::string read(const std::string& entry) const;

private:
    struct Zip;
    std::string name_;
    std::unique_ptr<Zip> zip_;
};

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
