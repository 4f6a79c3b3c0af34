#include "engine/frame/capped_scenes.h"

#include "engine/milliseconds.h"
#include "engine/scene/build/map_scene.h"
#include "engine/scene/build/mesh_caps.h"
#include "engine/scene/instances/mesh_levels.h"

namespace nacre {

std::shared_ptr<const Scene> CappedScenes::show(const gpu::Device& device, const std::shared_ptr<const Scene>& scene,
                                                const Clip& clip, const View& view, Pace pace) {
    constexpr double kMostLive = 25;  // milliseconds
    if (!needsCaps(scene->representation, clip)) {
        clear();
        return scene;
    }
    const bool another = from_.lock() != scene;
    if (capped_ && !another && rotation_ == view.rotation && near_ == clip.near) return capped_;
    clear();
    if (another) milliseconds_ = 0;
    from_ = scene;
    rotation_ = view.rotation;
    near_ = clip.near;
    if (pace == Pace::live && milliseconds_ > kMostLive) return scene;
    const auto start = Clock::now();
    const Representation caps = meshCaps(scene->representation, view, clip);
    capped_ = scene;
    if (!caps.triangles.empty()) {
        Representation whole = scene->representation;
        joinPart(whole, caps);
        // With fewer levels, vertices would differ from those of the bake.
        if (shapeBytes(whole) <= passes::mostShapeBytes(device.caps())) {
            auto made = std::make_shared<Scene>(makeOrderedScene(device, std::move(whole)));
            made->order = scene->order;
            capped_ = std::move(made);
        }
    }
    milliseconds_ = millisecondsSince(start);
    return capped_;
}

}  // namespace nacre
