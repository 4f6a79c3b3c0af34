#include "engine/occlusion/scene_occlusion.h"

#include <algorithm>

#include "engine/occlusion/cache.h"

namespace nacre {
namespace {

using passes::Nearest;

/// The path of the depth maps, if the device is to choose.
OcclusionMaps automaticMaps(const gpu::Caps& caps, Nearest nearest) {
    if (caps.software) return OcclusionMaps::splat;
    return nearest == Nearest::encoded ? OcclusionMaps::encoded : OcclusionMaps::fragdepth;
}

const char* nameOf(OcclusionMaps maps) {
    switch (maps) {
        case OcclusionMaps::encoded:
            return "encoded";
        case OcclusionMaps::fragdepth:
            return "fragdepth";
        default:
            return "splat";
    }
}

std::uint64_t countUnseen(const std::vector<bool>& seen) {
    return static_cast<std::uint64_t>(std::count(seen.begin(), seen.end(), false));
}

/// What decides a texel beside the scene's shapes.
std::string howBaked(const gpu::Caps& caps, const passes::OcclusionOptions& options) {
    return std::to_string(options.directions) + " directions, " + std::to_string(options.budgetBytes) + " bytes, " +
           nameOf(options.path) + ", " + std::string(caps.encoded.name) + ", " + caps.deviceName + ", " +
           caps.driverName + ", " + std::to_string(caps.driverVersion) + ", " + std::to_string(caps.maxImageSize);
}

}  // namespace

template <typename Work>
void SceneOcclusion::orDrop(Work&& work) {
    try {
        work();
    } catch (...) {
        device_.settle();
        bake_.reset();
        try {
            executor_.forget("occlusion");
        } catch (const vk::SystemError&) {
            // The depth maps stay until the next bake.
        }
        throw;
    }
}

void SceneOcclusion::begin(const RenderSettings& settings) {
    orDrop([&] { make(settings); });
}

void SceneOcclusion::make(const RenderSettings& settings) {
    const std::tuple wanted{settings.occlusion.directions, settings.occlusion.bytes, settings.occlusion.maps};
    if (settings.occlusion.directions == 0 || (bake_ && baked_ == wanted)) return;
    if (representation_.spheres.empty() && representation_.cylinders.empty()) return;  // no atlas of no patches
    const auto start = Clock::now();
    device_->waitIdle();  // frames for the window may still read the streams and the atlas
    bake_.reset();
    passes::OcclusionOptions options{settings.occlusion.directions, settings.occlusion.bytes, settings.occlusion.maps};
    if (options.path == OcclusionMaps::automatic) options.path = automaticMaps(device_.caps(), nearest_);
    cache_ = occlusionCache(settings.occlusion.cache);
    cacheName_ = cache_.on() ? occlusionCacheName(representation_, howBaked(device_.caps(), options)) : "";
    worthKeeping_ = settings.occlusion.worthKeeping;
    const auto kept = readOcclusion(cache_, cacheName_, representation_, device_.caps().maxImageSize);
    if (kept)
        bake_ = std::make_unique<passes::OcclusionBake>(device_, executor_, geometry_, pipelines_, scene_,
                                                        representation_, options, *kept);
    else
        bake_ =
            std::make_unique<passes::OcclusionBake>(device_, geometry_, pipelines_, scene_, representation_, options);
    scene_ = passes::makeSceneBuffers(device_, representation_);  // the looks hold patch addresses now
    if (!kept) bake_->finish(executor_);
    baked_ = wanted;
    directionMilliseconds_ = 0;
    stats_.bakeMilliseconds = millisecondsSince(start);
    stats_.occlusion = {bake_->directions(),
                        0,
                        bake_->layout().sphereEdge,
                        bake_->texels(),
                        nameOf(options.path),
                        bake_->maps().pixels(),
                        bake_->maps().perBatch(),
                        bake_->bytes(),
                        0};
    if (!kept) return;
    stats_.occlusion.cached = true;
    stats_.occlusion.done = bake_->directions();
    stats_.occlusion.mapPixels = stats_.occlusion.mapsPerBatch = 0;  // none were drawn
    stats_.occlusion.bytes = kept->atlas.size();
    stats_.occlusion.neverSeen = countUnseen(kept->seenSpheres);
}

/// Keeps the finished bake_ on disk, if it took long enough.
void SceneOcclusion::keep(std::vector<std::uint8_t> atlas) {
    if (!cache_.on() || stats_.bakeMilliseconds < worthKeeping_) return;
    writeOcclusion(cache_, cacheName_,
                   {bake_->layout(), std::move(atlas), bake_->seenSpheres(), stats_.occlusion.texels});
}

/// Shows what is done so far; when that is all, drops what only the bake_ needs.
void SceneOcclusion::show(Clock::time_point start) {
    bake_->finish(executor_);
    stats_.occlusion.done = bake_->directionsDone();
    stats_.occlusion.asked = bake_->asked();
    if (bake_->directionsDone() == bake_->directions()) {
        executor_.forget("occlusion");
        std::vector<std::uint8_t> atlas;
        if (cache_.on()) atlas = bake_->atlasTexels();
        bake_->release();
        stats_.occlusion.neverSeen = countUnseen(bake_->seenSpheres());
        stats_.bakeMilliseconds += millisecondsSince(start);
        keep(std::move(atlas));
        return;
    }
    stats_.bakeMilliseconds += millisecondsSince(start);
}

void SceneOcclusion::advance(double milliseconds) {
    if (!bake_) return;
    orDrop([&] {
        const auto start = Clock::now();
        const int before = bake_->directionsDone();
        while (bake_->directionsDone() < bake_->directions()) {
            const double left = milliseconds - millisecondsSince(start);
            const int done = bake_->directionsDone();
            if (done > before && left < directionMilliseconds_) break;
            // As many as fit the time that is left, by what the last ones took.
            const double fit = directionMilliseconds_ > 0 ? left / directionMilliseconds_ : 1;
            const auto stepStart = Clock::now();
            bake_->step(executor_, static_cast<std::uint32_t>(std::clamp(fit, 1.0, 16.0)));
            directionMilliseconds_ = millisecondsSince(stepStart) / (bake_->directionsDone() - done);
        }
        if (bake_->directionsDone() > before) show(start);
    });
}

void SceneOcclusion::finish(const RenderSettings& settings) {
    begin(settings);
    if (settings.occlusion.directions == 0 || !bake_ || bake_->directionsDone() == bake_->directions()) return;
    orDrop([&] {
        const auto start = Clock::now();
        while (bake_->directionsDone() < bake_->directions()) {
            bake_->step(executor_);
            if (settings.occlusion.onProgress)
                settings.occlusion.onProgress(static_cast<double>(bake_->directionsDone()) / bake_->directions());
        }
        show(start);
    });
}

}  // namespace nacre
