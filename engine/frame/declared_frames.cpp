#include "engine/frame/declared_frames.h"

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

#include "engine/frame/debug_frame.h"

namespace nacre {
namespace {

// Structured bindings name every member: a new one does not compile until it is compared.

auto membersOf(const graph::EncodedFormat& e) {
    const auto& [rung, name, format, channels, steps, farthest, ordered] = e;
    return std::tuple(rung, name, format, channels, steps, farthest, ordered);
}

auto membersOf(const ScreenTarget& t) {
    const auto& [image, format, output, pass, clear, window] = t;
    return std::tuple(std::string_view(image), format, output, std::string_view(pass), clear, window);
}

auto membersOf(const ScreenOptions& o) {
    const auto& [extent, visibility, encoded, atlas, targets, prepass, name, shaded, edges, placed, alone, rims, shadow,
                 layers, samples, layersByTiles, intoPicture] = o;
    return std::tuple(extent, visibility, membersOf(encoded), atlas, targets.size(), prepass, std::string_view(name),
                      shaded, edges, placed, alone, rims, shadow, layers, samples, layersByTiles, intoPicture);
}

auto membersOf(const PictureEnd& e) {
    const auto& [image, first, masked, samples] = e;
    return std::tuple(image, first, masked, samples);
}

auto membersOf(const FrameShape& s) {
    const auto& [options, debug, end, picture, window, overlay, merge, transient] = s;
    return std::tuple(membersOf(options), debug, end, membersOf(picture), window, overlay, merge, transient);
}

}  // namespace

bool operator==(const FrameShape& a, const FrameShape& b) {
    return membersOf(a) == membersOf(b) &&
           std::ranges::equal(a.options.targets, b.options.targets,
                              [](const auto& x, const auto& y) { return membersOf(x) == membersOf(y); });
}

ScreenFrame declare(const FrameShape& shape, const Recorder& recorder) {
    if (shape.debug != DebugView::none) return debugFrame(shape.debug, shape.options, recorder);
    if (shape.end != FrameEnd::sumOnWindow) return screenFrame(shape.options, recorder);
    ScreenFrame frame;
    frame.graph = graph::Graph(shape.options.name);
    return frame;
}

graph::PlanCaps planCaps(graph::PlanCaps caps, const FrameShape& shape) {
    caps.merge = caps.merge && shape.merge;
    caps.transient = caps.transient && shape.transient;
    caps.storeAll = caps.storeAll || !shape.transient;
    return caps;
}

bool DeclaredFrames::find(const FrameShape& shape) {
    const auto found = std::ranges::find_if(frames_, [&](const auto& frame) { return frame->shape == shape; });
    if (found == frames_.end()) return false;
    frames_.splice(frames_.begin(), frames_, found);
    return true;
}

std::shared_ptr<DeclaredFrame> DeclaredFrames::begin(const FrameShape& shape) {
    auto made = std::make_shared<DeclaredFrame>();
    made->shape = shape;
    made->targets.assign(shape.options.targets.begin(), shape.options.targets.end());
    made->shape.options.targets = made->targets;
    made->frame = declare(made->shape, Recorder(made->shown));
    return made;
}

void DeclaredFrames::keep(std::shared_ptr<DeclaredFrame> frame) {
    frame->plan = graph::compile(frame->frame.graph, planCaps(caps_, frame->shape));
    frame->recording = std::make_unique<gpu::Recording>(frame->frame.graph, frame->plan);
    frames_.push_front(std::move(frame));
    if (frames_.size() > kMost) frames_.pop_back();
}

}  // namespace nacre
