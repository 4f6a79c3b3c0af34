#pragma once
// Scenes with meshes that the near plane cuts: each view gets the scene with their caps (mesh_caps.h). The bake ignores
// caps, and stays.

#include <memory>

#include "engine/frame/scene.h"

namespace nacre {

class CappedScenes {
public:
    enum class Pace {
        complete,
        live  ///< a moving view: omits caps that cost a noticeable part of a frame
    };

    /// The scene for a view: unchanged where no mesh is cut. The last result is kept.
    std::shared_ptr<const Scene> show(const gpu::Device& device, const std::shared_ptr<const Scene>& scene,
                                      const Clip& clip, const View& view, Pace pace);
    /// Forgets the last result. Call before the scene changes.
    void clear() { capped_ = {}; }

private:
    std::shared_ptr<const Scene> capped_;
    std::weak_ptr<const Scene> from_;  // of capped_, as are:
    glm::dmat3 rotation_{1.0};
    double near_ = 0;
    double milliseconds_ = 0;
};

}  // namespace nacre
