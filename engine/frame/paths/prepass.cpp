#include "engine/frame/paths/paths.h"
#include "engine/frame/record.h"
#include "engine/passes/geometry_passes.h"

namespace nacre {

void declarePrepass(Frame& f, graph::Image& depth, const Rounds& rounds) {
    for (const graph::Share& share : rounds.shares())
        f.graphics("opaque prepass")
            .share(share)
            .depth(depth, clearFirst(share, 1.0f))
            .record(drawsFirst(f, [](const auto&, const passes::SceneView& scene) {
                return passes::opaquePrepass(scene.plates != PlateShape::none);
            }));
}

}  // namespace nacre
