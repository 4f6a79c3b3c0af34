#include "engine/frame/declared_frames.h"

#include <algorithm>
#include <utility>

namespace nacre {
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
    made->targets.assign(shape.targets.begin(), shape.targets.end());
    made->shape.targets = made->targets;
    made->frame = declareFrame(made->shape, made->shown);
    return made;
}

void DeclaredFrames::keep(std::shared_ptr<DeclaredFrame> frame) {
    frame->plan = graph::compile(frame->frame.graph, planCaps(caps_, frame->shape));
    frame->recording = std::make_unique<gpu::Recording>(frame->frame.graph, frame->plan);
    frames_.push_front(std::move(frame));
    if (frames_.size() > kMost) frames_.pop_back();
}

}  // namespace nacre
