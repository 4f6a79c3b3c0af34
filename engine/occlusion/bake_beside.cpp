// A bake beside a window's frames: submitted in slices, without waiting.
#include <utility>

#include "engine/occlusion/scene_occlusion.h"

namespace nacre::occlusion {

void SceneOcclusion::prepareBeside(const OcclusionSettings& settings, bool hurry) {
    const bool others = settings.directions > 0 && !is<Idle>() && wanted_ != wanted(settings);
    if (others || isOutdated()) {
        stopBounce();
        if (others || is<Finished>() || (hurry && before_.bake)) replaceShown();
    }
    prepare(settings);
}

void SceneOcclusion::replaceShown() {
    Before shown = before_;
    const bool incomplete = is<Baking>() && !shown.bake;
    if (const std::shared_ptr<Bake> bake = there(); !shown.bake && bake && bake->shows()) shown = {bake, of_.buffers};
    drop();
    if (incomplete && shown.bake) shown.bake->release();
    before_ = std::move(shown);
}

double SceneOcclusion::advanceBeside(const OcclusionSettings& settings, const OcclusionPace& pace) {
    cancelOnError([&] {
        prepareBeside(settings, !pace.mustFit);
        if (const auto* preparing = std::get_if<Preparing>(&state_)) {
            constexpr double kAny = 1e300;  // finite: the host's limit of listed primitives applies
            if (preparing->result.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
                make(allowed(pace.sliceMilliseconds), {DepthMaps::kMostPerBatch, kAny});
            return;  // the next call starts the bake
        }
        if (executor_.makesPipelines() || !awaitBounce(0)) return;
        if (submission_ && submission_->pending()) {
            if (!submission_->done()) return;
            collect(std::get<Baking>(state_));
        }
        if (auto* baking = std::get_if<Baking>(&state_)) submit(*baking, pace);
    });
    if (is<Idle>()) return 1;
    if (is<Preparing>() || isOutdated()) return 0;
    if (is<Bouncing>()) return kShareBeforeBounce;
    const auto* baking = std::get_if<Baking>(&state_);
    return baking ? baking->shown : 1;
}

/// Submits the atlas update if enough has changed, and the next part of the bake if allowed.
void SceneOcclusion::submit(Baking& baking, const OcclusionPace& pace) {
    Bake& bake = *baking.bake;
    const bool showing = bake.betweenSteps() && share() > baking.shown &&
                         (bake.complete() || (!before_.bake && baking.unshown >= pace.showMilliseconds));
    const Allowance allowance = allowed(pace.sliceMilliseconds);
    const bool working = !bake.complete() && (!pace.mustFit || bake.leastUnits() <= allowance.units);
    if (!showing && !working) return;
    if (!submission_) submission_ = std::make_unique<gpu::Submission>(device_, "occlusion");
    baking.submittedAt = Clock::now();
    const double share = this->share();
    submission_->submit([&](gpu::CommandBuffer& commands) {
        const auto record = [&](const graph::Graph& g, const gpu::Imports& imports, gpu::Timer* timer) {
            const graph::Plan plan = graph::compile(g, device_.caps().plan);
            executor_.record(commands, g, plan, imports, submission_->descriptors(), timer);
        };
        if (showing) {
            graph::Graph g("occlusion finish");
            gpu::Imports imports;
            bake.declareFinish(g, imports);
            record(g, imports, nullptr);
        }
        if (!working) return;
        graph::Graph g("occlusion");
        gpu::Imports imports;
        baking.submittedUnits = bake.declareSlice(g, imports, allowance);
        record(g, imports, &submission_->timer());
    });
    if (!showing) return;
    // Frames submitted from here on see the update. A complete bake counts as shown only after the device has finished
    // it.
    if (!bake.complete()) baking.shown = share;
    baking.unshown = 0;
    stats_.occlusion.done = bake.directionsDone();
    stats_.occlusion.asked = bake.asked();
}

/// Handles a finished submission.
void SceneOcclusion::collect(Baking& baking) {
    const double waited = millisecondsSince(baking.submittedAt);
    if (baking.submittedUnits > 0) {
        const double took = submission_->timer().milliseconds().value_or(waited);
        learn(std::exchange(baking.submittedUnits, 0.0), took);
        baking.unshown += took;
        stats_.bakeMilliseconds += took;
        baking.bake->sliceDone();
    } else if (baking.bake->complete()) {
        wrapUp();
    }
}

/// Waits for work submitted beside frames.
void SceneOcclusion::finishFlight() {
    if (!submission_ || !submission_->pending()) return;
    submission_->wait();
    collect(std::get<Baking>(state_));
}

}  // namespace nacre::occlusion
