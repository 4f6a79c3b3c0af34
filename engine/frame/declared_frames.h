#pragma once
// Frames that are declared and planned once, and recorded as often as they are wanted: a steady frame differs from the
// one before in what it shows, not in its passes.

#include <list>
#include <memory>
#include <string>
#include <vector>

#include "engine/frame/screen.h"
#include "engine/gpu/recording.h"
#include "engine/graph/plan.h"
#include "engine/settings.h"

namespace nacre {

/// What becomes of the picture that a scene's passes make.
enum class FrameEnd : std::uint8_t {
    left,            ///< on the device
    readBack,        ///< the host reads it
    window,          ///< it is the window's image
    onWindow,        ///< it is brought to the window as it is
    scaledOnWindow,  ///< or from another size
    firstSample,     ///< it begins a sum of samples, which is brought to the window
    nextSample,      ///< or is added to one
    sumOnWindow,     ///< the sum alone is: no scene is drawn
};

/// All that decides what a frame declares, and how it is planned.
struct FrameShape {
    ScreenOptions options;
    DebugView debug = DebugView::none;
    FrameEnd end = FrameEnd::left;
    graph::Extent window;  ///< of ends on it, its image
    bool overlay = false;  ///< over it
    bool merge = true, transient = true;
};
bool operator==(const FrameShape& a, const FrameShape& b);

struct DeclaredFrame {
    FrameShape shape;
    std::vector<ScreenTarget> targets;  ///< those of the shape
    std::shared_ptr<ShownScene> shown = std::make_shared<ShownScene>();
    ScreenFrame frame;
    graph::Plan plan;
    std::unique_ptr<gpu::Recording> recording;
    gpu::Imports imports;  ///< of the frame to be recorded next
};

/// The passes of a shape's scene. Those of its end are for whoever asked for it.
ScreenFrame declare(const FrameShape& shape, const Recorder& recorder);
/// How the device's caps and the shape want a frame planned.
graph::PlanCaps planCaps(graph::PlanCaps caps, const FrameShape& shape);

class DeclaredFrames {
public:
    static constexpr std::size_t kMost = 16;

    explicit DeclaredFrames(const graph::PlanCaps& caps) : caps_(caps) {}

    /// The frame of a shape: the one that is kept, or a new one.
    /// @param end  declares the shape's end where the frame is new: called with the frame
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
    /// Puts it first.
    bool find(const FrameShape& shape);
    static std::shared_ptr<DeclaredFrame> begin(const FrameShape& shape);
    void keep(std::shared_ptr<DeclaredFrame> frame);

    const graph::PlanCaps& caps_;
    std::list<std::shared_ptr<DeclaredFrame>> frames_;  // latest use first
};

}  // namespace nacre
