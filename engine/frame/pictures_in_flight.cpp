// Pictures that are drawn while the host prepares the next and codes the last: the device need not wait for it.

#include "engine/error.h"
#include "engine/frame/lens.h"
#include "engine/frame/picture_frames.h"

namespace nacre {

/// Whether it is one frame whose pixels the host reads where compute writes them.
bool PictureFrames::overlaps(const RenderSettings& settings) const {
    const FrameTuning& tuning = settings.tuning;
    const bool edges = settings.supersample == RenderSettings::kEdges;
    return device_.caps().tiles.shade && settings.debug == DebugView::none && !hasLens(settings) &&
           !tuning.countFragments && !tuning.timePasses && (edges ? drawsEdges(settings) : settings.supersample == 1) &&
           singleOrResolved(settings) == Samples::one;
}

/// @returns whether it can be drawn so
bool PictureFrames::submit(const RenderSettings& settings, const passes::Atlas& atlas, bool alpha) {
    const bool edges = settings.supersample == RenderSettings::kEdges;
    Started next;
    next.background = settings.background;
    next.alpha = alpha;
    next.wanted = wantedOf(settings);
    checkSize(next.wanted.view);
    next.seen = frames_.see(
        {settings, atlas, next.wanted.view, pictureTargets(settings), "screen", FrameEnd::readBack, nullptr, edges});
    if (!next.seen.colors() || edges != next.seen.shape.options.edges) return false;
    const std::shared_ptr<DeclaredFrame> declared = declare(next.seen);
    SceneFrames::bind(*declared, next.seen);
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
    stats_.samples = edges ? RenderSettings::kEdgeSamples : 1;
    tell(next.seen, settings.tuning);
    counts_ = next.seen.counts;
    started_.push_back(std::move(next));
    return true;
}

void PictureFrames::start(RenderSettings settings, const passes::Atlas& atlas, bool alpha) {
    settings.fine = false;
    if (overlaps(settings) && submit(settings, atlas, alpha)) return;
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
    const passes::TileFrame& colors = *first.seen.colors();
    colors.numbers.buffer.invalidate();
    CodedPicture picture =
        codePixels(reinterpret_cast<const std::uint32_t*>(colors.numbers.buffer.mapped),
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
