#pragma once
// Occlusion of the renderer's scene: starts the requested bake, advances it, and stores it on disk.

#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <tuple>
#include <variant>

#include "engine/baked_occlusion.h"
#include "engine/gpu/submission.h"
#include "engine/milliseconds.h"
#include "engine/occlusion/bake.h"
#include "engine/results.h"
#include "engine/settings.h"
#include "engine/storage/disk_cache.h"

namespace nacre::occlusion {

/// A scene, kept alive while its bake reads it.
struct SceneToBake {
    std::shared_ptr<const Representation> representation;
    std::shared_ptr<const passes::SceneBuffers> buffers;
};

class SceneOcclusion {
public:
    /// The settings that a bake depends on.
    using Wanted =
        std::tuple<int, std::uint64_t, OcclusionMaps, std::uint32_t, bool, bool, std::optional<ViewDirection>>;
    static Wanted wanted(const OcclusionSettings& s, const std::optional<ViewDirection>& viewDirection = {}) {
        return {s.directions, s.bytes, s.maps, s.detail, s.bounce, s.moving, viewDirection};
    }

    /// Both must outlive this.
    SceneOcclusion(const gpu::Device& device, gpu::Executor& executor);
    ~SceneOcclusion() { drop(); }

    /// Sets the maps that OcclusionMaps::automatic means. Call before the first bake.
    void setAutomaticMaps(OcclusionMaps maps) { automaticMaps_ = maps; }

    /// Waits for submitted work, and drops all bakes.
    void setScene(SceneToBake scene);
    /// Sets the same primitives at other positions. The old bake is shown until a new one is done.
    void moveScene(SceneToBake scene);

    /// Whether a thread reads the scene's representation.
    bool readsScene() const { return is<Preparing>() || is<Bouncing>(); }
    /// Bounced light that is not finished is given up: colours may change now.
    void stopBounce();
    /// After the scene's colours changed: bounced light begins again, and the old one is shown until it is there.
    /// @returns whether there is any
    bool recolored();

    /// Starts the requested bake unless it exists or there is nothing to bake. A bake from the cache is done at once.
    /// @param viewDirection  if a single view shows the bake
    void begin(const OcclusionSettings& settings, const std::optional<ViewDirection>& viewDirection = {});
    /// Works on the current bake for about `milliseconds`, at least one direction.
    void advance(double milliseconds);
    /// Starts the requested bake, and completes it.
    void finish(const OcclusionSettings& settings, const std::optional<ViewDirection>& viewDirection = {});
    /// As finish(), always with a new bake. @returns its results
    BakedOcclusion baked(const OcclusionSettings& settings);
    /// As Renderer::advanceOcclusion, beside frames. @returns the share that is shown
    double advanceBeside(const OcclusionSettings& settings, const OcclusionPace& pace);
    /// Null: nothing was requested, or there is nothing to bake.
    const Bake* bake() const { return there().get(); }
    /// The shown atlas.
    passes::Atlas atlas() const;
    /// Options in force, and statistics.
    const BakeStats& stats() const { return stats_; }
    /// The finished share, 0..1; 1 if there is nothing to bake.
    double share() const;

private:
    /// Advances the bake. On failure drops it, since its number of directions may be wrong; the next call starts over.
    template <typename Work>
    void cancelOnError(Work&& work) {
        try {
            work();
        } catch (...) {
            dropFailed();
            throw;
        }
    }
    void dropFailed();
    /// Result of the preparation thread.
    struct Prepared {
        std::string cacheName;
        std::optional<FinishedOcclusion> kept;
        BakePreparation bake;
    };

    // The states, with their data:
    //   Idle       nothing requested, or nothing to bake                       prepare() -> Preparing
    //   Preparing  a thread prepares the bake or reads a cached one            make() -> Baking, or Finished if cached
    //   Baking     the device renders one direction after another              wrapUp() -> Finished, or Bouncing
    //   Bouncing   a thread computes bounced light or reads a cached one       takeBounce() -> Finished
    //   Finished   all directions are shown; data only for baking is dropped   recolored() -> Bouncing
    // drop() leads from each to Idle. If the scene moves on or other settings are wanted, the bake becomes before_.
    struct Idle {};
    struct Preparing {
        std::stop_source stop;
        std::future<Prepared> result;  // its destructor waits
        Clock::time_point began = Clock::now();
        ~Preparing() { stop.request_stop(); }
    };
    struct Baking {
        explicit Baking(std::shared_ptr<Bake> made) : bake(std::move(made)) {}
        std::shared_ptr<Bake> bake;
        double shown = 0;           // the share that frames show
        double unshown = 0;         // milliseconds of work not shown yet
        double submittedUnits = 0;  // units in flight beside frames; 0: none
        bool atlasWritten = false;  // with the last part
        Clock::time_point submittedAt{};
    };
    using Openness = std::shared_ptr<const std::vector<std::uint8_t>>;
    struct Bouncing {
        std::shared_ptr<Bake> bake;  // shown meanwhile
        Openness open;               // its texels
        std::stop_source stop;
        std::future<FinishedOcclusion> result;  // its destructor waits
        Clock::time_point began = Clock::now();
        ~Bouncing() { stop.request_stop(); }
    };
    struct Finished {
        explicit Finished(std::shared_ptr<Bake> done, Openness texels = {})
            : bake(std::move(done)), open(std::move(texels)) {}
        std::shared_ptr<Bake> bake;
        Openness open;  // for bounced light in other colours; null: there is none
    };
    template <typename State>
    bool is() const {
        return std::holds_alternative<State>(state_);
    }
    /// The bake, if there is one.
    std::shared_ptr<Bake> there() const;

    /// Starts preparing the requested bake unless it exists, is being prepared, or there is nothing to bake.
    void prepare(const OcclusionSettings& settings, const std::optional<ViewDirection>& viewDirection = {});
    /// As prepare(), beside frames: the last bake stays visible. Of a moving scene a running bake continues.
    /// @param hurry  drop a running bake of earlier positions
    void prepareBeside(const OcclusionSettings& settings, bool hurry);
    /// Drops the bake, but shows it, or the one that was shown instead, until the next is done.
    void replaceShown();
    /// Whether a bake of earlier positions exists or is being prepared.
    bool isOutdated() const { return !is<Idle>() && of_.buffers != scene_.buffers; }
    void drop();
    /// Takes over the prepared bake. @param least, most  work per submission
    void make(const Allowance& least, const Allowance& most);
    void runSlice(Bake& bake, const Allowance& allowance);
    void runWaited(Baking& baking);
    void start(const OcclusionSettings& settings, const std::optional<ViewDirection>& viewDirection);
    void submit(Baking& baking, const OcclusionPace& pace);
    void finishFlight();
    void collect(Baking& baking);
    void wrapUp();
    void startBounce(std::shared_ptr<Bake> bake, Openness open);
    /// Starts it again where it was given up.
    void resumeBounce();
    /// Takes over bounced light if it is finished within this time. @returns whether none is left to wait for
    bool awaitBounce(double milliseconds);
    void takeBounce();
    static constexpr double kShareBeforeBounce = 0.99;
    Allowance allowed(double milliseconds) const;
    void learn(double units, double milliseconds);
    void show(Baking& baking, Clock::time_point start);

    const gpu::Device& device_;
    gpu::Executor& executor_;
    BakeStats stats_;
    SceneToBake scene_;  // the current scene
    SceneToBake of_;     // the scene of the bake
    bool moved_ = false;
    std::variant<Idle, Preparing, Baking, Bouncing, Finished> state_;
    struct Before {
        std::shared_ptr<Bake> bake;
        std::shared_ptr<const passes::SceneBuffers> of;
    };
    Before before_;        // of earlier positions or other settings, shown until the current one is done
    Wanted wanted_{};      // the request that led to the bake
    BakeOptions options_;  // the request, resolved
    OcclusionMaps automaticMaps_ = OcclusionMaps::fragdepth;
    DiskCache cache_;        // off: do not cache the bake
    std::string cacheName_;  // of the bake
    double worthKeeping_ = 0;
    std::vector<std::uint8_t>* texels_ = nullptr;  // receives the finished atlas; null: unused

    double unitsPerMillisecond_;                   // recent speed of the device
    std::unique_ptr<gpu::Submission> submission_;  // beside frames
    std::unique_ptr<gpu::Timer> timer_;            // for submissions that are waited for
    std::unique_ptr<gpu::DescriptorPool> sets_;    // likewise, of a part and the atlas
};

}  // namespace nacre::occlusion
