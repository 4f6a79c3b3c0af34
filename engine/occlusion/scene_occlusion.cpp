#include "engine/occlusion/scene_occlusion.h"

#include <algorithm>

#include "engine/occlusion/cache.h"

namespace nacre::occlusion {
namespace {

/// The path of the depth maps, if the device is to choose.
OcclusionMaps automaticMaps(const gpu::Caps& caps) {
    if (caps.software) return OcclusionMaps::splat;
    return caps.visibility == Visibility::encoded ? OcclusionMaps::encoded : OcclusionMaps::fragdepth;
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
std::string howBaked(const gpu::Caps& caps, const BakeOptions& options) {
    return std::to_string(options.directions) + " directions, " + std::to_string(options.budgetBytes) + " bytes, " +
           std::to_string(options.detail) + " texels, " + nameOf(options.path) + ", " + std::string(caps.encoded.name) +
           ", " + caps.deviceName + ", " + caps.driverName + ", " + std::to_string(caps.driverVersion) + ", " +
           std::to_string(caps.maxImageSize);
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

void SceneOcclusion::begin(const OcclusionSettings& settings) {
    orDrop([&] { make(settings); });
}

void SceneOcclusion::make(const OcclusionSettings& settings) {
    const std::tuple wanted{settings.directions, settings.bytes, settings.maps, settings.detail};
    if (settings.directions == 0 || (bake_ && baked_ == wanted)) return;
    if (representation_.spheres.empty() && representation_.cylinders.empty()) return;  // no atlas of no patches
    const auto start = Clock::now();
    device_->waitIdle();  // frames for the window may still read the streams and the atlas
    bake_.reset();
    BakeOptions options{settings.directions, settings.bytes, settings.maps, settings.detail};
    if (options.path == OcclusionMaps::automatic) options.path = automaticMaps(device_.caps());
    cache_ = occlusionCache(settings.cache);
    cacheName_ = cache_.on() ? occlusionCacheName(representation_, howBaked(device_.caps(), options)) : "";
    worthKeeping_ = settings.worthKeeping;
    const auto kept = readOcclusion(cache_, cacheName_, representation_, device_.caps().maxImageSize);
    if (kept)
        bake_ = std::make_unique<Bake>(device_, executor_, scene_, representation_, options, *kept);
    else
        bake_ = std::make_unique<Bake>(device_, scene_, representation_, options);
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
    if (bake_->complete()) {
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

passes::Atlas SceneOcclusion::atlas() const {
    if (!bake_) return {};
    const OcclusionLayout& layout = bake_->layout();
    return {&bake_->atlas(),        layout.sphereEdge,        layout.around, layout.along,
            layout.spherePatches(), layout.cylinderPatches(), bake_->cells()};
}

double SceneOcclusion::share() const {
    return bake_ ? static_cast<double>(bake_->mapsDone()) / static_cast<double>(bake_->mapsInAll()) : 1;
}

void SceneOcclusion::advance(double milliseconds) {
    if (!bake_) return;
    orDrop([&] {
        const auto start = Clock::now();
        const std::uint64_t before = bake_->mapsDone();
        while (!bake_->complete()) {
            const double left = milliseconds - millisecondsSince(start);
            const std::uint64_t done = bake_->mapsDone();
            if (done > before && left < directionMilliseconds_) break;
            // As many as fit the time that is left, by what the last ones took.
            const double fit = directionMilliseconds_ > 0 ? left / directionMilliseconds_ : 1;
            const auto stepStart = Clock::now();
            bake_->step(executor_, static_cast<std::uint32_t>(std::clamp(fit, 1.0, 16.0)));
            directionMilliseconds_ = millisecondsSince(stepStart) / static_cast<double>(bake_->mapsDone() - done);
        }
        if (bake_->mapsDone() > before) show(start);
    });
}

void SceneOcclusion::finish(const OcclusionSettings& settings) {
    begin(settings);
    if (settings.directions == 0 || !bake_ || bake_->complete()) return;
    orDrop([&] {
        const auto start = Clock::now();
        while (!bake_->complete()) {
            bake_->step(executor_);
            if (settings.onProgress) settings.onProgress(share());
        }
        show(start);
    });
}

}  // namespace nacre::occlusion
