#include "engine/frame/window_end.h"

#include "engine/frame/record.h"
#include "engine/passes/read_back.h"

namespace nacre {
namespace {

/// Work that resamples a picture. @param how  called when the frame is recorded
template <typename How>
graph::Work resamples(graph::Image picture, passes::NearestFrom from, How how) {
    const auto read = [=](const gpu::PipelineContext& c) {
        passes::Resampling r = how();
        r.from = from == passes::NearestFrom::texture ? from : fromEarlierPass(c);
        return r;
    };
    return {[=](gpu::PassContext& c) { passes::resample(c, c.view(picture), read(c)); },
            [=](gpu::PipelineContext& c) { passes::wantResampling(c, read(c)); }};
}

}  // namespace

graph::Image WindowEnd::addWindow(graph::Graph& frame, graph::Image picture, graph::Extent window, std::uint32_t count,
                                  passes::NearestFrom from) const {
    graph::Image shown = frame.importImage("window", {format, window}, kWindowState, true);
    graph::PassBuilder pass = frame.graphics("resample");
    (from == passes::NearestFrom::inputAttachment ? pass.input(picture) : pass.samples(picture)).color(shown);
    if (samples)
        pass.record(resamples(picture, from, [of = samples, count, coded = coded()] {
            return passes::Resampling{count, coded, of->share};
        }));
    return shown;
}

graph::Image WindowEnd::addPicture(graph::Graph& frame, graph::Image picture, graph::Extent window,
                                   std::uint32_t count) const {
    return addWindow(frame, picture, window, count, passes::NearestFrom::texture);
}

graph::Image WindowEnd::addShownSum(graph::Graph& frame, graph::Image sum, graph::Extent window) const {
    return addWindow(frame, sum, window, 1, passes::NearestFrom::inputAttachment);
}

graph::Image WindowEnd::addSum(graph::Graph& frame, graph::Image sample, graph::Extent window, bool first, bool eye,
                               std::uint32_t views) const {
    graph::Image sum = frame.importImage("sum of samples", {kSumFormat, window}, passes::kTextureState);
    for (std::uint32_t i = 0; i < views; ++i) {
        std::optional<graph::Clear> clear;
        if (first && i == 0) clear = graph::Clear{0.0f};
        graph::PassBuilder pass = frame.graphics(i == 0 ? "sum of samples" : "sum of the other eye's samples");
        (eye ? pass.samples(sample) : pass.input(sample)).color(sum, clear);
        if (!samples) continue;
        const auto how = [=, of = samples] {
            passes::Resampling added{1, false, 1, true};
            if (eye) added = of->ofEyes[views > 1 ? i : of->eye];
            if (views > 1) added.layer = i;
            return added;
        };
        pass.record(resamples(sample, eye ? passes::NearestFrom::texture : passes::NearestFrom::inputAttachment, how));
    }
    return sum;
}

/// @param several  attachment with several samples, resolved to the window after the overlay; none: drawn directly
void WindowEnd::addOverlay(graph::Graph& frame, graph::Image& window, std::optional<graph::Image>& several) const {
    graph::PassBuilder pass = frame.graphics("overlay");
    several ? pass.color(*several).resolve(window) : pass.color(window);
    pass.record(overlay);
}

void WindowEnd::declare(Frame& frame, const FrameShape& shape) const {
    graph::Graph& g = frame.graph;
    const Ending ending = shape.choice.ending;
    if (ending == Ending::firstSample || ending == Ending::nextSample)
        frame.sum =
            addSum(g, frame.targets[0], shape.window, ending == Ending::firstSample, shape.eye, shape.choice.views);
    if (shape.eye) return;
    if (ending == Ending::sumToWindow)
        frame.sum = g.importImage("sum of samples", {kSumFormat, shape.window}, passes::kTextureState);
    if (ending == Ending::copiedToWindow || ending == Ending::scaledToWindow)
        frame.targets.push_back(
            addPicture(g, frame.targets[0], shape.window, ending == Ending::copiedToWindow ? 1 : 0));
    if (frame.sum) frame.targets.push_back(addShownSum(g, *frame.sum, shape.window));
    std::optional<graph::Image> none;
    if (shape.overlay) addOverlay(g, frame.targets.back(), ending == Ending::window ? frame.samples : none);
}

}  // namespace nacre
