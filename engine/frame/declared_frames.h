#pragma once
// Frames that are declared and planned once and recorded many times: steady frames differ in their data, not in their
// passes.

#include <list>
#include <memory>
#include <vector>

#include "engine/frame/screen.h"
#include "engine/gpu/recording.h"
#include "engine/graph/plan.h"
#include "engine/settings.h"

namespace nacre {

/// Destination of the picture that a scene's passes make.
enum class FrameEnd : std::uint8_t {
    left,            ///< stays on the device
    readBack,        ///< read by the host
    resolved,        ///< in the image of its picture
    coarse,          ///< the same, and read by the host, which finds where more samples are needed
    throughLens,     ///< that image blurred by depth, read by the host
    window,          ///< drawn into the window's image
    onWindow,        ///< copied to the window
    scaledOnWindow,  ///< scaled to the window
    firstSample,     ///< starts a sum of samples, which is shown in the window
    nextSample,      ///< adds to such a sum
    sumOnWindow,     ///< shows the sum only: no scene is drawn
};

/// The image that a picture's frames end in, and how one of them does.
struct PictureEnd {
    graph::ImageDesc image{};
    bool first = true;          ///< nothing is in it yet
    bool masked = false;        ///< only some pixels are replaced
    std::uint32_t samples = 1;  ///< n: n x n pixels of the frame are one of it
};

/// Everything that decides how a frame is declared and planned.
struct FrameShape {
    ScreenOptions options;
    DebugView debug = DebugView::none;
    FrameEnd end = FrameEnd::left;
    PictureEnd picture{};  ///< for ends in an image, and through the lens
    graph::Extent window;  ///< its image's size, for ends in a window
    bool overlay = false;  ///< the window has an overlay
    bool merge = true, transient = true;
};
bool operator==(const FrameShape& a, const FrameShape& b);

struct DeclaredFrame {
    FrameShape shape;
    std::vector<ScreenTarget> targets;  ///< targets of the shape
    std::shared_ptr<ShownScene> shown = std::make_shared<ShownScene>();
    ScreenFrame frame;
    graph::Plan plan;
    std::unique_ptr<gpu::Recording> recording;
    gpu::Imports imports;  ///< for the next recording
};

/// Declares the passes of a shape's scene. The caller declares the end.
ScreenFrame declare(const FrameShape& shape, const Recorder& recorder);
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
    /// Moves it to the front.
    bool find(const FrameShape& shape);
    static std::shared_ptr<DeclaredFrame> begin(const FrameShape& shape);
    void keep(std::shared_ptr<DeclaredFrame> frame);

    const graph::PlanCaps& caps_;
    std::list<std::shared_ptr<DeclaredFrame>> frames_;  // most recently used first
};

}  // namespace nacre
