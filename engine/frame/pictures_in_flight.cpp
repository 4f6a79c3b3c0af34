// Pictures that are drawn while the host prepares the next and codes the last, so that the device need not wait.

#include "engine/error.h"
#include "engine/frame/picture_frames.h"

namespace nacre {

/// Starts a picture of one frame whose pixels compute writes to host memory. @returns false for any other picture
bool PictureFrames::submit(const RenderSettings& settings, const passes::Atlas& atlas, bool alpha) {
    const auto isOneFrame = [&](const FrameChoice& choice) {
        return choice.refinement == Refinement::none && !choice.has(Effect::Kind::lens) && choice.shadedByCompute();
    };
    const FrameRequest request{settings, Part::whole, Ending::readBack, settings.view.quarterTurns};
    if (settings.tuning.countFragments || settings.tuning.timePasses || settings.supersample > 1 ||
        !isOneFrame(choose(request, frames_.facts(settings), device_.caps())))
        return false;
    const Wanted wanted = wholePicture(settings);
    checkSize(wanted.view);
    PreparedFrame prepared = prepare(request, {atlas, wanted.view});
    if (!isOneFrame(prepared.choice())) return false;
    const std::shared_ptr<DeclaredFrame> declared = declare(prepared);
    SceneFrames::bind(*declared, prepared);
    std::unique_ptr<gpu::Submission> submission;
    if (!spare_.empty()) {
        submission = std::move(spare_.back());
        spare_.pop_back();
    } else {
        submission = std::make_unique<gpu::Submission>(device_, "picture");
    }
    submission->submit([&](gpu::CommandBuffer& c) {
        executor_.record(c, *declared->recording, declared->imports, submission->descriptors());
    });
    if (last_ != declared) planText_.clear();
    last_ = declared;
    stats_.frames = 1;
    stats_.samples = prepared.choice().samples.count;
    note(prepared);
    counts_ = prepared.counts;
    Started& started = started_.emplace_back();
    started.background = settings.background;
    started.alpha = alpha;
    started.wanted = wanted;
    started.prepared = std::move(prepared);
    started.submission = std::move(submission);
    return true;
}

void PictureFrames::start(RenderSettings settings, const passes::Atlas& atlas, bool alpha) {
    settings.fine = false;
    if (submit(settings, atlas, alpha)) return;
    settle();
    CodedPicture picture = coded(settings, atlas, alpha);
    started_.emplace_back().picture = std::move(picture);
}

CodedPicture PictureFrames::finish() {
    if (started_.empty()) throw Error("cannot finish a picture", "", "none is started");
    Started first = std::move(started_.front());
    started_.pop_front();
    if (first.picture) return std::move(*first.picture);
    first.submission->wait();
    const passes::TileFrame& colors = *first.prepared.colors();
    colors.pixels().invalidate();
    CodedPicture picture =
        codePixels(reinterpret_cast<const std::uint32_t*>(colors.pixels().mapped),
                   {colors.rowPixels(), 1, first.wanted.inner}, first.background, first.alpha, stats_.coveredPixels);
    spare_.push_back(std::move(first.submission));
    return picture;
}

void PictureFrames::settle() {
    for (Started& one : started_)
        if (one.submission) one.submission->wait();
}

void PictureFrames::drop() { started_.clear(); }

}  // namespace nacre
