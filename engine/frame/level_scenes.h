#pragma once
// Scenes of millions of copies: each view gets a scene of the spheres that it shows, for any path.

#include "engine/frame/scene.h"
#include "engine/lists/seen_copies.h"
#include "engine/results.h"
#include "engine/scene/instances/sphere_levels.h"

namespace nacre {

class LevelScenes {
public:
    /// Whether levels draw a scene's views. They show no occlusion.
    static bool draws(const Representation& representation, const RenderSettings& settings);

    /// Grid places per pixel side where pixels have several samples: fewer in a large picture, to save memory.
    static std::uint32_t chooseGrid(std::uint32_t width, std::uint32_t height);

    /// The spheres that a view of such a scene shows, without copies. One sample per pixel.
    Representation show(const Representation& whole, const RenderSettings& settings, const View& view);
    /// As above, on the device. The levels are kept while the scene stays. @param edges  take several samples: the
    /// levels are finer, and spheres between pixel centres are found
    std::shared_ptr<const Scene> show(const gpu::Device& device, const std::shared_ptr<const Scene>& scene,
                                      const RenderSettings& settings, const View& view, bool edges);
    /// Counts of the last view.
    std::vector<CopyLevelCount> counts() const;

private:
    Representation shownBy(const Representation& whole, const RenderSettings& settings, const View& view, bool edges);

    std::weak_ptr<const Scene> leveled_;
    SphereLevels levels_;  // of the scene
    SeenCopies copies_;
};

}  // namespace nacre
