#pragma once
// The occlusion of the renderer's scene: which bake the settings ask for, how far it is, what is kept of it on disk.

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
    const Bake* bake() const { return there().get(); }
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

    // The states, each with what it alone has:
    //   Idle       nothing was asked for, or there is nothing to bake             prepare() -> Preparing
    //   Preparing  a thread finds out what the bake needs, or what was kept       make() -> Baking, or Finished if kept
    //   Baking     the device takes one direction after the other                 wrapUp() -> Finished
    //   Finished   all directions are shown, and what only the bake needs is gone
    // drop() leads from each of them to Idle. Where the scene has moved on, a Finished one becomes before_.
    struct Idle {};
    struct Preparing {
        std::stop_source stop;
        std::future<Prepared> result;  // whose destructor waits
        Clock::time_point began = Clock::now();
        ~Preparing() { stop.request_stop(); }
    };
    struct Baking {
        explicit Baking(std::shared_ptr<Bake> made) : bake(std::move(made)) {}
        std::shared_ptr<Bake> bake;
        double shown = 0;           // the share that frames show
        double unshown = 0;         // milliseconds of work that they do not show yet
        double submittedUnits = 0;  // of the bake that are in flight beside frames; 0: none
        Clock::time_point submittedAt{};
    };
    struct Finished {
        explicit Finished(std::shared_ptr<Bake> done) : bake(std::move(done)) {}
        std::shared_ptr<Bake> bake;
    };
    template <typename State>
    bool is() const {
        return std::holds_alternative<State>(state_);
    }
    /// The bake, if there is one by now.
    std::shared_ptr<Bake> there() const;

    using Wanted = std::tuple<int, std::uint64_t, OcclusionMaps, std::uint32_t>;
    /// Begins to prepare what the settings ask for, unless it is there, or on its way, or there is nothing to bake.
    void prepare(const OcclusionSettings& settings);
    /// The same beside frames, of a scene that moves: a bake that was begun goes on, and what was finished is shown
    /// until the next is. @param hurry  one that was begun for other places is given up
    void prepareBeside(const OcclusionSettings& settings, bool hurry);
    /// Whether there is a bake, or will be, of places that the scene has left.
    bool isOutdated() const { return !is<Idle>() && of_.buffers != scene_.buffers; }
    void drop();
    /// Makes the bake when it is prepared.
    /// @param least, most  what its submissions take on
    void make(const Allowance& least, const Allowance& most);
    void runSlice(Bake& bake, const Allowance& allowance);
    void submit(Baking& baking, const OcclusionPace& pace);
    void finishFlight();
    void collect(Baking& baking);
    void wrapUp();
    Allowance allowed(double milliseconds) const;
    void learn(double units, double milliseconds);
    void show(Baking& baking, Clock::time_point start);

    const gpu::Device& device_;
    gpu::Executor& executor_;
    BakeStats stats_;
    SceneToBake scene_;  // as it is now
    SceneToBake of_;     // that the bake is of, or will be
    bool moved_ = false;
    std::variant<Idle, Preparing, Baking, Finished> state_;
    std::shared_ptr<Bake> before_;  // of other places, finished: what is shown until this one is
    Wanted wanted_{};               // directions, budget, maps, detail: of the bake, or of before_
    BakeOptions options_;           // the same, as it is carried out
    DiskCache cache_;               // off: the bake is not to be kept
    std::string cacheName_;         // of the bake in it
    double worthKeeping_ = 0;
    std::vector<std::uint8_t>* texels_ = nullptr;  // who wants those of the finished atlas; null: nobody

    double unitsPerMillisecond_ = 10'000;          // that the device takes on, lately; first too few for any phone
    std::unique_ptr<gpu::Submission> submission_;  // beside frames
    std::unique_ptr<gpu::Timer> timer_;            // of what is waited for
};

}  // namespace nacre::occlusion
