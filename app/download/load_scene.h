#pragma once
// MolViewSpec scenes as INPUT. The files that they name come from the scene's archive, its folder, a map, the cache or
// the network.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/input_options.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre::app {

namespace mvs {
struct SceneFile;
}

/// The molecule of a scene, with its guide. Files at addresses in the scene are downloaded only if that is allowed;
/// files must be in its folder. @param bytes  of the scene's file @param onStep  as in mvs::SceneSources @throws
/// Error
Molecule loadScene(const InputOptions& input, std::string bytes, const ReadOptions& reading,
                   const std::function<void(double)>& onDownload = {}, const std::function<void()>& onStep = {});

/// Names and current contents of the files that a scene names: together with its own content they determine the
/// picture. Empty: INPUT is no scene, or names none. Downloads nothing.
std::string contentOfNamed(const InputOptions& input);

/// Duration of a snapshot in a movie, seconds: at rest, and in transition to the next.
struct SnapshotTimes {
    double linger = 0, transition = 0;
    std::string easing = {}, trajectory = {};  ///< of the transition, as named in the scene; empty: unnamed
    double animation = 0;                      ///< of its animation, while it is shown; 0: it has none
    bool loops = false;                        ///< its animation begins again
    bool camera = false;                       ///< its animation moves the camera
};
/// A scene of several snapshots: reads its file and the files that it names once.
class OpenScene {
public:
    /// @throws Error if its file is no scene
    explicit OpenScene(const InputOptions& input);
    ~OpenScene();

    /// loadScene() for the snapshot in `input`. @param seconds  of its animation; empty: without it
    Molecule snapshot(const InputOptions& input, const ReadOptions& reading,
                      const std::function<void(double)>& onDownload = {}, std::optional<double> seconds = {});
    std::vector<SnapshotTimes> times() const;

private:
    std::unique_ptr<const mvs::SceneFile> file_;
    std::map<std::string, std::string> fetched_;  ///< by the names in the scene
    std::size_t held_ = 0;
};

}  // namespace nacre::app
