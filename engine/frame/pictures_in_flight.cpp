// Pictures that are drawn while the host prepares the next and codes the last: the device need not wait for it.

#include "engine/error.h"
#include "engine/frame/picture_frames.h"

namespace nacre {

/// Starts a picture of one frame whose pixels the host reads where compute writes them. @returns whether it is one
bool PictureFrames::submit(const RenderSettings& settings, const passes::Atlas& atlas, bool alpha) {
    const auto isOneFrame = [&](const FrameChoice& choice) {
        return choice.refinement == Refinement::none && !choice.has(Effect::Kind::lens) && choice.shadedByCompute();
    };
    const FrameRequest request{settings, Part::whole, Ending::readBack, settings.view.quarterTurns};
    if (settings.tuning.countFragments || settings.tuning.timePasses || settings.supersample > 1 ||
        !isOneFrame(choose(request, frames_.facts(settings), device_.caps())))
        return false;
    Started next;
    next.background = settings.background;
    next.alpha = alpha;
    next.wanted = wantedOf(settings);
    checkSize(next.wanted.view);
    next.prepared = prepare(request, {atlas, next.wanted.view});
    if (!isOneFrame(next.prepared.choice())) return false;
    const std::shared_ptr<DeclaredFrame> declared = declare(next.prepared);
    SceneFrames::bind(*declared, next.prepared);
    if (!spare_.empty()) {
        next.submission = std::move(spare_.back());
        spare_.pop_back();
    } else {
        next.submission = std::make_unique<gpu::Submission>(device_, "picture");
    }
    next.submission->submit([&](gpu::CommandBuffer& c) {
        executor_.record(c, *declared->recording, declared->imports, next.submission->descriptors());
    });
    if (last_ != declared) planText_.clear();
    last_ = declared;
    stats_.frames = 1;
    stats_.samples = next.prepared.choice().samples.count;
    note(next.prepared, settings.tuning);
    counts_ = next.prepared.counts;
    started_.push_back(std::move(next));
    return true;
}

void PictureFrames::start(RenderSettings settings, const passes::Atlas& atlas, bool alpha) {
    settings.fine = false;
    if (submit(settings, atlas, alpha)) return;
    settle();
    Started next;
    next.picture = coded(settings, atlas, alpha);
    started_.push_back(std::move(next));
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
