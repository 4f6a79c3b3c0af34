#pragma once
// The occlusion of the renderer's scene: which bake the settings ask for, how far it is, what is kept of it on disk.

#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <tuple>

#include "engine/baked_occlusion.h"
#include "engine/gpu/submission.h"
#include "engine/milliseconds.h"
#include "engine/occlusion/bake.h"
#include "engine/results.h"
#include "engine/settings.h"
#include "engine/storage/disk_cache.h"

namespace nacre::occlusion {

/// A scene, as long as its bake needs it.
struct SceneToBake {
    std::shared_ptr<const Representation> representation;
    std::shared_ptr<const passes::SceneBuffers> buffers;
};

class SceneOcclusion {
public:
    /// Both outlive this.
    SceneOcclusion(const gpu::Device& device, gpu::Executor& executor) : device_(device), executor_(executor) {}
    ~SceneOcclusion() { drop(); }

    /// Waits for what is in flight, and drops all that was baked.
    void setScene(SceneToBake scene);
    /// The same primitives at other places. What was baked is shown until a later bake is done.
    void moveScene(SceneToBake scene);

    /// Makes the bake that the settings ask for, unless it is there, or there is nothing to bake. One that was kept is
    /// done at once.
    void begin(const OcclusionSettings& settings);
    /// Works for about `milliseconds`, at least one direction, on the bake that begin() made.
    void advance(double milliseconds);
    /// All of it.
    void finish(const OcclusionSettings& settings);
    /// The same, and what it came to. It is baked anew.
    BakedOcclusion baked(const OcclusionSettings& settings);
    /// As Renderer::advanceOcclusion beside frames. @returns the share that is shown
    double advanceBeside(const OcclusionSettings& settings, const OcclusionPace& pace);
    /// Null: nothing was asked for yet, or there is nothing to bake.
    const Bake* bake() const { return bake_.get(); }
    /// What is shown of it so far.
    passes::Atlas atlas() const;
    /// What was chosen and done.
    const BakeStats& stats() const { return stats_; }
    /// The share that is done, 0..1; 1 if there is nothing to bake.
    double share() const;

private:
    /// Does some work on the bake. One that failed half way may have counted directions that it does not know of, and
    /// is dropped: the next begins anew.
    template <typename Work>
    void orDrop(Work&& work) {
        try {
            work();
        } catch (...) {
            dropFailed();
            throw;
        }
    }
    void dropFailed();
    /// What a thread of its own finds out of a bake before it can begin.
    struct Prepared {
        std::string cacheName;
        std::optional<FinishedOcclusion> kept;
        BakePreparation bake;
    };
    using Wanted = std::tuple<int, std::uint64_t, OcclusionMaps, std::uint32_t>;
    /// Begins to prepare what the settings ask for, unless it is there, or on its way, or there is nothing to bake.
    void prepare(const OcclusionSettings& settings);
    /// The same beside frames, of a scene that moves: a bake that was begun goes on, and what was finished is shown
    /// until the next is. @param hurry  one that was begun for other places is given up
    void prepareBeside(const OcclusionSettings& settings, bool hurry);
    bool isCurrent() const { return of_.buffers == scene_.buffers; }
    void drop();
    /// Makes the bake when it is prepared.
    /// @param least, most  what its submissions take on
    void make(const Allowance& least, const Allowance& most);
    void forgetPreparation();
    void runSlice(const Allowance& allowance);
    void submit(const OcclusionPace& pace);
    void finishFlight();
    void collect();
    void wrapUp();
    Allowance allowed(double milliseconds) const;
    void learn(double units, double milliseconds);
    void keep(std::vector<std::uint8_t> atlas);
    void show(Clock::time_point start);

    const gpu::Device& device_;
    gpu::Executor& executor_;
    BakeStats stats_;
    SceneToBake scene_;  // as it is now
    SceneToBake of_;     // that bake_ is of, or will be
    bool moved_ = false;
    // Frames in flight hold the one that they show.
    std::shared_ptr<Bake> before_;  // of other places, done: what is shown until bake_ is
    std::shared_ptr<Bake> bake_;
    Wanted baked_{};         // directions, budget, maps, detail: of bake_, or of what is being prepared
    DiskCache cache_;        // off: the bake is not to be kept
    std::string cacheName_;  // of the bake in it
    double worthKeeping_ = 0;
    std::vector<std::uint8_t>* texels_ = nullptr;  // who wants those of the finished atlas; null: nobody

    std::optional<std::stop_source> stopPreparing_;
    std::future<Prepared> preparing_;
    BakeOptions options_;  // of what is being prepared
    Clock::time_point began_;

    double unitsPerMillisecond_ = 10'000;          // that the device takes on, lately; first too few for any phone
    std::unique_ptr<gpu::Submission> submission_;  // beside frames
    std::unique_ptr<gpu::Timer> timer_;            // of what is waited for
    double submittedUnits_ = 0;                    // of the bake in it; 0: none
    Clock::time_point submittedAt_;
    double unshown_ = 0;  // milliseconds of work that frames do not show yet
    double shown_ = 0;    // the share that they show
};

}  // namespace nacre::occlusion
