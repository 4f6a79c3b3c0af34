#include "engine/occlusion/scene_occlusion.h"

#include <algorithm>

#include "engine/occlusion/cache.h"
#include "engine/occlusion/moving_atoms.h"
#include "engine/occlusion/on_thread.h"

namespace nacre::occlusion {
namespace {

/// Milliseconds per submission while a caller waits. Longer ones make phones stutter, and some phones abort submissions
/// that take seconds.
constexpr double kWaitedMilliseconds = 30;

/// Speed of a device before its first submission, units per millisecond: low enough for any phone, or any graphics
/// card. A card starts with whole batches, so that it compiles no pipelines for smaller ones.
constexpr double kSpeedOfPhone = 10'000, kSpeedOfCard = 200'000;

/// Minimum value while a molecule moves: surfaces exposed since the bake are dark, not black.
constexpr std::uint32_t kLeastOfMoved = 102;

const char* mapsName(OcclusionMaps maps) {
    switch (maps) {
        case OcclusionMaps::encoded:
            return "encoded";
        case OcclusionMaps::fragdepth:
            return "fragdepth";
        default:
            return "tiles";
    }
}

/// Memory limit of a bake. @param vertices  of meshes
std::uint64_t computeBudget(std::uint64_t bytes, std::size_t vertices) {
    constexpr std::uint64_t kOfMaps = 16ull << 20, kOfVertex = 48;
    return bytes == OcclusionSettings::kUsualBytes ? std::max(bytes, kOfMaps + kOfVertex * vertices) : bytes;
}

std::uint64_t countUnseen(const std::vector<bool>& seen) {
    return static_cast<std::uint64_t>(std::count(seen.begin(), seen.end(), false));
}

/// Everything except the shapes that affects texels.
std::string howBaked(const gpu::Caps& caps, const BakeOptions& options) {
    return std::to_string(options.directions) + " directions, " + std::to_string(options.budgetBytes) + " bytes, " +
           std::to_string(options.detail) + " texels, " + (options.bounce ? "bounced, " : "") +
           (options.moving ? "moving, " : "") + mapsName(options.path) + ", " + std::string(caps.encodedMaps.name) +
           ", " + caps.deviceName + ", " + caps.driverName + ", " + std::to_string(caps.driverVersion) + ", " +
           std::to_string(caps.maxImageSize);
}

/// Whether an atlas would hold anything: lines have no occlusion.
bool hasPatches(const Representation& scene) {
    return !scene.spheres.empty() || !scene.cylinders.empty() || !scene.meshVertices.empty();
}

}  // namespace

SceneOcclusion::SceneOcclusion(const gpu::Device& device, gpu::Executor& executor)
    : device_(device),
      executor_(executor),
      unitsPerMillisecond_(device.caps().type == "discrete" ? kSpeedOfCard : kSpeedOfPhone) {}

std::shared_ptr<Bake> SceneOcclusion::there() const {
    if (const auto* baking = std::get_if<Baking>(&state_)) return baking->bake;
    if (const auto* bouncing = std::get_if<Bouncing>(&state_)) return bouncing->bake;
    if (const auto* finished = std::get_if<Finished>(&state_)) return finished->bake;
    return nullptr;
}

void SceneOcclusion::dropFailed() {
    device_.settle();
    submission_.reset();
    drop();
    try {
        executor_.forget("occlusion");
    } catch (const vk::SystemError&) {
        // The depth maps are kept for the next bake.
    }
}

void SceneOcclusion::setScene(SceneToBake scene) {
    drop();
    of_ = {};
    scene_ = std::move(scene);
    moved_ = false;
}

void SceneOcclusion::moveScene(SceneToBake scene) {
    scene_ = std::move(scene);
    moved_ = true;
}

void SceneOcclusion::start(const OcclusionSettings& settings, const std::optional<ViewDirection>& viewDirection) {
    if (isOutdated()) drop();
    prepare(settings, viewDirection);
    if (is<Preparing>()) make(device_.caps().asynchronous ? allowed(kWaitedMilliseconds) : Allowance(), Allowance());
}

void SceneOcclusion::begin(const OcclusionSettings& settings, const std::optional<ViewDirection>& viewDirection) {
    cancelOnError([&] {
        start(settings, viewDirection);
        if (const auto bake = there(); bake && !bake->shows()) finishFlight(), bake->finish(executor_);
    });
}

void SceneOcclusion::prepare(const OcclusionSettings& asked, const std::optional<ViewDirection>& viewDirection) {
    if (asked.directions == 0 || scene_.buffers == nullptr) return;
    if (!is<Idle>()) {
        if (wanted_ == wanted(asked, viewDirection)) return resumeBounce();
        drop();
    }
    if (!hasPatches(*scene_.representation)) return;
    of_ = scene_;
    wanted_ = wanted(asked, viewDirection);
    const OcclusionSettings settings = settingsForMotion(asked, *of_.representation);
    const bool bounce = settings.bounce && of_.representation->copies.colors.empty();
    options_ = {settings.directions, computeBudget(settings.bytes, of_.representation->meshVertices.size()),
                settings.maps,       settings.detail,
                viewDirection,       bounce,
                settings.moving};
    // Rays take longer than any bake, and the noise of few directions would be most of what is left of the error.
    if (bounce) options_.directions = std::min(2 * options_.directions, OcclusionSettings::kMostDirections);
    if (options_.path == OcclusionMaps::automatic) options_.path = automaticMaps_;
    cache_ = occlusionCache(moved_ ? std::string() : settings.cache);  // positions of moving atoms do not recur
    worthKeeping_ = settings.worthKeeping;
    auto& preparing = state_.emplace<Preparing>();
    const auto prepare = [&caps = device_.caps(), scene = of_.representation, options = options_, cache = cache_,
                          stop = preparing.stop.get_token()] {
        Prepared p;
        if (cache.on()) p.cacheName = occlusionCacheName(*scene, howBaked(caps, options));
        p.kept = readOcclusion(cache, p.cacheName, *scene, caps.maxImageSize);
        if (!p.kept) p.bake = prepareBake(caps, *scene, options, stop);
        return p;
    };
    preparing.result = onThread(prepare);
}

void SceneOcclusion::drop() {
    if (submission_ && submission_->pending()) device_.settle();
    submission_.reset();
    state_.emplace<Idle>();
    before_ = {};
}

void SceneOcclusion::make(const Allowance& least, const Allowance& most) {
    auto& preparing = std::get<Preparing>(state_);
    Prepared p = preparing.result.get();
    const Clock::time_point began = preparing.began;
    cacheName_ = p.cacheName;
    const bool kept = p.kept.has_value();
    const std::uint64_t atlasBytes = kept ? p.kept->atlas.size() : 0;
    const auto bake =
        kept ? std::make_shared<Bake>(device_, executor_, *of_.buffers, *of_.representation, options_, *p.kept)
             : std::make_shared<Bake>(device_, *of_.buffers, *of_.representation, options_, std::move(p.bake));
    bake->wantPipelines(executor_, least, most);
    if (kept)
        state_.emplace<Finished>(bake);
    else
        state_.emplace<Baking>(bake);
    stats_.bakeMilliseconds = millisecondsSince(began);
    stats_.bounceMilliseconds = 0;
    stats_.occlusion = {bake->directions(),        0,
                        bake->layout().sphereEdge, bake->texels(),
                        mapsName(options_.path),   bake->maps().pixels(),
                        bake->maps().perBatch(),   bake->bytes(),
                        options_.budgetBytes,      0};
    if (!kept) return;
    stats_.occlusion.cached = true;
    stats_.occlusion.done = bake->directions();
    stats_.occlusion.mapPixels = stats_.occlusion.mapsPerBatch = 0;  // no maps were drawn
    stats_.occlusion.bytes = atlasBytes;
    stats_.occlusion.neverSeen = countUnseen(bake->seenSpheres());
    if (options_.bounce) startBounce(bake, std::make_shared<std::vector<std::uint8_t>>(std::move(p.kept->atlas)));
}

/// After everything is shown: frees data needed only for baking, and stores bakes that took long enough.
void SceneOcclusion::wrapUp() {
    const std::shared_ptr<Bake> bake = there();
    executor_.forget("occlusion");
    std::vector<std::uint8_t> atlas;
    if (cache_.on() || texels_ || options_.bounce) atlas = bake->atlasTexels();
    Openness open = options_.bounce ? std::make_shared<std::vector<std::uint8_t>>(atlas) : nullptr;
    if (texels_) *texels_ = atlas;
    bake->release();
    stats_.occlusion.neverSeen = countUnseen(bake->seenSpheres());
    if (cache_.on() && stats_.bakeMilliseconds >= worthKeeping_)
        writeOcclusion(cache_, cacheName_,
                       {bake->layout(), std::move(atlas), bake->seenSpheres(), stats_.occlusion.texels});
    if (open) return startBounce(bake, std::move(open));
    before_ = {};
    state_.emplace<Finished>(bake);
}

/// Shows the finished part.
void SceneOcclusion::show(Baking& baking, Clock::time_point start) {
    if (!baking.atlasWritten) baking.bake->finish(executor_);
    baking.shown = share();
    stats_.occlusion.done = baking.bake->directionsDone();
    stats_.occlusion.asked = baking.bake->asked();
    stats_.bakeMilliseconds += millisecondsSince(start);
    if (baking.bake->complete()) wrapUp();
}

BakedOcclusion SceneOcclusion::baked(const OcclusionSettings& settings) {
    drop();
    OcclusionSettings anew = settings;
    anew.cache.clear();
    anew.bounce = false;
    std::vector<std::uint8_t> texels;
    texels_ = &texels;
    try {
        finish(anew);
    } catch (...) {
        texels_ = nullptr;
        throw;
    }
    texels_ = nullptr;
    const std::shared_ptr<Bake> bake = there();
    if (!bake) return {};
    const OcclusionLayout& layout = bake->layout();
    BakedOcclusion baked;
    baked.sphereEdge = layout.sphereEdge;
    baked.around = layout.around;
    baked.along = layout.along;
    baked.width = layout.width;
    baked.sphereRows = layout.sphereRows;
    baked.cylinderRows = layout.cylinderRows;
    baked.texels = std::move(texels);
    return baked;
}

passes::Atlas SceneOcclusion::atlas() const {
    const std::shared_ptr<Bake> shown = before_.bake ? before_.bake : there();
    if (!shown || !shown->shows()) return {};
    const OcclusionLayout& layout = shown->layout();
    return {&shown->atlas(),
            layout.sphereEdge,
            layout.around,
            layout.along,
            layout.spherePatches(),
            layout.cylinderPatches(),
            shown->cells(),
            (before_.bake ? before_.of : of_.buffers) == scene_.buffers ? 0 : kLeastOfMoved,
            shown,
            shown->bounced(),
            shown->cells() || (shown->bounced() && layout.sphereEdge > 1 && device_.caps().gathersTexels)};
}

double SceneOcclusion::share() const {
    if (is<Bouncing>()) return kShareBeforeBounce;
    const std::shared_ptr<Bake> bake = there();
    return bake ? static_cast<double>(bake->mapsDone()) / static_cast<double>(bake->mapsInAll()) : 1;
}

/// Work that the device can complete in this time. Software devices have no watchdog.
Allowance SceneOcclusion::allowed(double milliseconds) const {
    return {DepthMaps::kMostPerBatch, milliseconds * unitsPerMillisecond_};
}

void SceneOcclusion::learn(double units, double milliseconds) {
    if (milliseconds <= 0) return;
    const double rate = units / milliseconds;
    // A slowdown counts at once, a speed-up gradually.
    unitsPerMillisecond_ = std::min(rate, unitsPerMillisecond_ + 0.5 * std::max(rate - unitsPerMillisecond_, 0.0));
}

void SceneOcclusion::runSlice(Bake& bake, const Allowance& allowance) {
    const auto start = Clock::now();
    graph::Graph g("occlusion");
    gpu::Imports imports;
    const double units = bake.declareSlice(g, imports, allowance);
    const graph::Plan plan = graph::compile(g, device_.caps().plan);
    // Uses timestamps: the host's clock would include the driver's compilation in the first submission. Software
    // devices wait after each pass for a timestamp and execute synchronously, so they use the host's clock.
    const bool timed = device_.caps().asynchronous;
    if (timed && !timer_) timer_ = std::make_unique<gpu::Timer>(device_);
    device_.submitAndWait(
        [&](gpu::CommandBuffer& c) { executor_.record(c, g, plan, imports, timed ? timer_.get() : nullptr); });
    executor_.reset();
    const double took = millisecondsSince(start);
    learn(units, timed ? timer_->milliseconds().value_or(took) : took);
    bake.sliceDone();
}

/// Runs a part that takes kWaitedMilliseconds, and in the same submission the atlas update, if it was the last and time
/// is left: on a GPU each wait costs more than the work of a small molecule.
void SceneOcclusion::runWaited(Baking& baking) {
    Bake& bake = *baking.bake;
    const auto start = Clock::now();
    if (!timer_) timer_ = std::make_unique<gpu::Timer>(device_);
    if (!sets_) sets_ = std::make_unique<gpu::DescriptorPool>(device_);
    sets_->reset();  // a failed recording may have left some
    const Allowance allowance = allowed(kWaitedMilliseconds);
    double units = 0;
    device_.submitAndWait([&](gpu::CommandBuffer& commands) {
        const auto record = [&](const graph::Graph& g, const gpu::Imports& imports, gpu::Timer* timer) {
            executor_.record(commands, g, graph::compile(g, device_.caps().plan), imports, *sets_, timer);
        };
        graph::Graph g("occlusion");
        gpu::Imports imports;
        units = bake.declareSlice(g, imports, allowance);
        record(g, imports, timer_.get());
        if (!bake.sliceRecorded() || allowance.units < units + bake.finishUnits()) return;
        graph::Graph finish("occlusion finish");
        gpu::Imports finished;
        bake.declareFinish(finish, finished);
        record(finish, finished, nullptr);
        baking.atlasWritten = true;
    });
    sets_->reset();
    learn(units, timer_->milliseconds().value_or(millisecondsSince(start)));
    bake.submissionDone();
}

void SceneOcclusion::advance(double milliseconds) {
    cancelOnError([&] {
        finishFlight();
        if (!awaitBounce(milliseconds)) return;
        auto* baking = std::get_if<Baking>(&state_);
        if (!baking) return;
        Bake& bake = *baking->bake;
        const auto start = Clock::now();
        const std::uint64_t before = bake.mapsDone();
        while (!bake.complete()) {
            const double left = milliseconds - millisecondsSince(start);
            if (bake.mapsDone() > before && bake.betweenSteps() && left <= 0) break;
            runSlice(bake, allowed(std::max(left, 0.0)));
        }
        if (bake.mapsDone() > before) show(*baking, start);
    });
}

void SceneOcclusion::finish(const OcclusionSettings& settings, const std::optional<ViewDirection>& viewDirection) {
    cancelOnError([&] { start(settings, viewDirection); });
    if (settings.directions == 0) return;
    cancelOnError([&] {
        finishFlight();
        if (auto* baking = std::get_if<Baking>(&state_)) {
            const auto start = Clock::now();
            while (!baking->bake->complete()) {
                if (device_.caps().asynchronous)
                    runWaited(*baking);
                else
                    runSlice(*baking->bake, Allowance());
                if (settings.onProgress && baking->bake->betweenSteps()) settings.onProgress(share());
            }
            show(*baking, start);
        }
        while (!awaitBounce(kWaitedMilliseconds))
            if (settings.onProgress) settings.onProgress(share());
    });
}

}  // namespace nacre::occlusion
