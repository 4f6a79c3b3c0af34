// A scene's bake beside a window's frames: submitted slice by slice, and never waited for.
#include <utility>

#include "engine/occlusion/scene_occlusion.h"

namespace nacre::occlusion {

void SceneOcclusion::prepareBeside(const OcclusionSettings& settings, bool hurry) {
    if (!isCurrent() && (bake_ || preparing_.valid())) {
        const bool done = bake_ && shown_ == 1;
        if (done) {
            // It is shown until the next is done; the one before it went with the end of this one.
            before_ = std::move(bake_);
        } else if (hurry && before_) {
            std::shared_ptr<Bake> shown = std::move(before_);
            drop();
            before_ = std::move(shown);
        }
    }
    prepare(settings);
}

double SceneOcclusion::advanceBeside(const OcclusionSettings& settings, const OcclusionPace& pace) {
    orDrop([&] {
        prepareBeside(settings, !pace.mustFit);
        if (preparing_.valid()) {
            constexpr double kAny = 1e300;  // the host lists no more for it than beside frames
            if (preparing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
                make(allowed(pace.sliceMilliseconds), {DepthMaps::kMostPerBatch, kAny});
            return;  // the next call begins with it
        }
        if (executor_.makesPipelines()) return;
        if (!bake_ || shown_ == 1) return;
        if (submission_ && submission_->pending()) {
            if (!submission_->done()) return;
            collect();
        }
        if (shown_ < 1) submit(pace);
    });
    if (!isCurrent() && bake_) return 0;
    return bake_ ? shown_ : preparing_.valid() ? 0 : 1;
}

/// Submits what frames are to show, if there is enough of it, and the next part of the bake, if it may.
void SceneOcclusion::submit(const OcclusionPace& pace) {
    const bool showing = bake_->betweenSteps() && share() > shown_ &&
                         (bake_->complete() || (!before_ && unshown_ >= pace.showMilliseconds));
    const Allowance allowance = allowed(pace.sliceMilliseconds);
    const bool working = !bake_->complete() && (!pace.mustFit || bake_->leastUnits() <= allowance.units);
    if (!showing && !working) return;
    if (!submission_) submission_ = std::make_unique<gpu::Submission>(device_, "occlusion");
    submittedAt_ = Clock::now();
    const double share = this->share();
    submission_->submit([&](const vk::raii::CommandBuffer& commands) {
        const auto record = [&](const graph::Graph& g, const gpu::Imports& imports, gpu::Timer* timer) {
            const graph::Plan plan = graph::compile(g, device_.caps().plan);
            executor_.record(commands, g, plan, imports, submission_->descriptors(), timer);
        };
        if (showing) {
            graph::Graph g("occlusion finish");
            gpu::Imports imports;
            bake_->declareFinish(g, imports);
            record(g, imports, nullptr);
        }
        if (!working) return;
        graph::Graph g("occlusion");
        gpu::Imports imports;
        submittedUnits_ = bake_->declareSlice(g, imports, allowance);
        record(g, imports, &submission_->timer());
    });
    if (!showing) return;
    // Frames that are submitted from here on see it. All is shown when it is known to be done.
    shown_ = bake_->complete() ? shown_ : share;
    unshown_ = 0;
    stats_.occlusion.done = bake_->directionsDone();
    stats_.occlusion.asked = bake_->asked();
}

/// What was submitted is done.
void SceneOcclusion::collect() {
    const double waited = millisecondsSince(submittedAt_);
    if (submittedUnits_ > 0) {
        const double took = submission_->timer().milliseconds().value_or(waited);
        learn(std::exchange(submittedUnits_, 0.0), took);
        unshown_ += took;
        stats_.bakeMilliseconds += took;
        bake_->sliceDone();
        return;
    }
    if (!bake_->complete()) return;
    shown_ = 1;
    wrapUp();
}

/// Waits for what is in flight beside frames.
void SceneOcclusion::finishFlight() {
    if (!submission_ || !submission_->pending()) return;
    submission_->wait();
    collect();
}

}  // namespace nacre::occlusion
