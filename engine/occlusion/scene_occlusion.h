#pragma once
// The occlusion of the renderer's scene: which bake the settings ask for, how far it is, what is kept of it on disk.

#include <memory>
#include <tuple>

#include "engine/milliseconds.h"
#include "engine/occlusion/bake.h"
#include "engine/results.h"
#include "engine/settings.h"
#include "engine/storage/disk_cache.h"

namespace nacre::occlusion {

class SceneOcclusion {
public:
    /// All of them outlive this. `stats` is told what was chosen and done.
    SceneOcclusion(const gpu::Device& device, gpu::Executor& executor, const Representation& representation,
                   const passes::SceneBuffers& scene, FrameStats& stats)
        : device_(device), executor_(executor), representation_(representation), scene_(scene), stats_(stats) {}

    /// Makes the bake that the settings ask for, unless it is there, or there is nothing to bake. One that was kept is
    /// done at once.
    void begin(const OcclusionSettings& settings);
    /// Works for about `milliseconds`, at least one direction, on the bake that begin() made.
    void advance(double milliseconds);
    /// All of it.
    void finish(const OcclusionSettings& settings);
    /// The scene is about to change.
    void drop() { bake_.reset(); }
    /// Null: nothing was asked for yet, or there is nothing to bake.
    const Bake* bake() const { return bake_.get(); }
    /// What is shown of it so far.
    passes::Atlas atlas() const;
    /// The share that is done, 0..1; 1 if there is nothing to bake.
    double share() const;

private:
    /// Does some work on the bake. One that failed half way may have counted directions that it does not know of, and
    /// is dropped: the next begins anew.
    template <typename Work>
    void orDrop(Work&& work);
    void make(const OcclusionSettings& settings);
    void keep(std::vector<std::uint8_t> atlas);
    void show(Clock::time_point start);

    const gpu::Device& device_;
    gpu::Executor& executor_;
    const Representation& representation_;
    const passes::SceneBuffers& scene_;
    FrameStats& stats_;
    std::unique_ptr<Bake> bake_;
    std::tuple<int, std::uint64_t, OcclusionMaps, std::uint32_t>
        baked_{};                       // directions, budget, maps, detail: of bake_
    double directionMilliseconds_ = 0;  // that one direction took, lately
    DiskCache cache_;                   // off: the bake is not to be kept
    std::string cacheName_;             // of the bake in it
    double worthKeeping_ = 0;
};

}  // namespace nacre::occlusion
