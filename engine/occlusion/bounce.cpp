// Bounced light of the scene, once its occlusion is finished: on a thread, while the bake without it is shown.
#include <algorithm>
#include <utility>

#include "engine/occlusion/bounced_light.h"
#include "engine/occlusion/cache.h"
#include "engine/occlusion/on_thread.h"
#include "engine/occlusion/scene_occlusion.h"

namespace nacre::occlusion {

void SceneOcclusion::startBounce(std::shared_ptr<Bake> bake, Openness open) {
    auto& bouncing = state_.emplace<Bouncing>();
    bouncing.bake = std::move(bake);
    bouncing.open = std::move(open);
    const auto work = [scene = of_.representation, layout = bouncing.bake->layout(),
                       seen = bouncing.bake->seenSpheres(), texels = bouncing.bake->texels(), open = bouncing.open,
                       cache = cache_, name = cacheName_, worthKeeping = worthKeeping_,
                       side = device_.caps().maxImageSize, stop = bouncing.stop.get_token()] {
        const Clock::time_point start = Clock::now();
        const std::string bouncedName = cache.on() ? bouncedCacheName(*scene, name) : std::string();
        std::optional<FinishedOcclusion> kept = readOcclusion(cache, bouncedName, *scene, side);
        if (kept && kept->bounced) return std::move(*kept);
        FinishedOcclusion finished{layout, bouncedLight(*scene, layout, *open, stop), seen, texels, true};
        if (cache.on() && !stop.stop_requested() && millisecondsSince(start) >= worthKeeping)
            writeOcclusion(cache, bouncedName, finished);
        return finished;
    };
    bouncing.result = onThread(work);
}

bool SceneOcclusion::awaitBounce(double milliseconds) {
    auto* bouncing = std::get_if<Bouncing>(&state_);
    if (!bouncing) return true;
    const std::chrono::duration<double, std::milli> time(milliseconds);
    if (bouncing->result.wait_for(time) != std::future_status::ready) return false;
    takeBounce();
    return true;
}

/// A bake of its own has the atlas with bounced light: frames in flight read the one before.
void SceneOcclusion::takeBounce() {
    auto& bouncing = std::get<Bouncing>(state_);
    const FinishedOcclusion finished = bouncing.result.get();
    const auto bake = std::make_shared<Bake>(device_, executor_, *of_.buffers, *of_.representation, options_, finished);
    const double before = std::exchange(stats_.bounceMilliseconds, millisecondsSince(bouncing.began));
    stats_.bakeMilliseconds += stats_.bounceMilliseconds - before;
    stats_.occlusion.bytes = std::max(stats_.occlusion.bytes, bouncedBytes(finished.layout));
    before_ = {};
    state_.emplace<Finished>(bake, Openness(bouncing.open));
}

void SceneOcclusion::stopBounce() {
    auto* bouncing = std::get_if<Bouncing>(&state_);
    if (!bouncing) return;
    bouncing->stop.request_stop();
    bouncing->result.wait();
    const std::shared_ptr<Bake> bake = bouncing->bake;
    state_.emplace<Finished>(bake, Openness(bouncing->open));
}

void SceneOcclusion::resumeBounce() {
    const auto* finished = std::get_if<Finished>(&state_);
    if (finished && finished->open && !finished->bake->bounced()) recolored();
}

bool SceneOcclusion::recolored() {
    const auto* finished = std::get_if<Finished>(&state_);
    if (!finished || !finished->open) return false;
    const std::shared_ptr<Bake> bake = finished->bake;
    startBounce(bake, Openness(finished->open));
    return true;
}

}  // namespace nacre::occlusion
