#pragma once
// Frames that are declared and planned once and recorded many times: steady frames differ in their data, not in their
// passes.

#include <list>
#include <memory>
#include <vector>

#include "engine/frame/frame.h"
#include "engine/gpu/recording.h"
#include "engine/graph/plan.h"

namespace nacre {

struct DeclaredFrame {
    FrameShape shape;
    std::vector<ScreenTarget> targets;  ///< targets of the shape
    std::shared_ptr<ShownScene> shown = std::make_shared<ShownScene>();
    Frame frame;
    graph::Plan plan;
    std::unique_ptr<gpu::Recording> recording;
    gpu::Imports imports;  ///< for the next recording
};

/// The device's caps, changed for a shape.
graph::PlanCaps planCaps(graph::PlanCaps caps, const FrameShape& shape);

class DeclaredFrames {
public:
    static constexpr std::size_t kMost = 16;

    explicit DeclaredFrames(const graph::PlanCaps& caps) : caps_(caps) {}

    /// The frame of a shape, kept or new.
    /// @param end  declares the shape's end; called with a new frame only
    template <typename DeclareEnd>
    const std::shared_ptr<DeclaredFrame>& of(const FrameShape& shape, const DeclareEnd& end) {
        if (!find(shape)) {
            const auto made = begin(shape);
            end(made->frame);
            keep(made);
        }
        return frames_.front();
    }
    std::size_t size() const { return frames_.size(); }

private:
    /// Moves a match to the front.
    bool find(const FrameShape& shape);
    static std::shared_ptr<DeclaredFrame> begin(const FrameShape& shape);
    void keep(std::shared_ptr<DeclaredFrame> frame);

    const graph::PlanCaps& caps_;
    std::list<std::shared_ptr<DeclaredFrame>> frames_;  // most recently used first
};

}  // namespace nacre
