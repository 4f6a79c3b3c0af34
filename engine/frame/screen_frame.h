#pragma once
// The screen frame, declared: its images and passes, and what a reader wants to know of each pass. The renderer draws
// this graph and `nacre plan` prints it. Nothing here calls Vulkan.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/device_options.h"
#include "engine/graph/encoded_format.h"
#include "engine/graph/graph.h"
#include "engine/passes/shader_table.h"

namespace nacre {

/// A picture that the frame makes.
struct ScreenTarget {
    const char* image;
    VkFormat format;
    passes::Writes writes;  ///< color, surface or identity
    graph::Clear clear{0.0f};
    bool window = false;  ///< it is the window's image, and left to the display
};

/// State in which a window's image comes and goes.
constexpr graph::State kWindowState{VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, 0, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};

/// What an application shows.
constexpr ScreenTarget kScreenTargets[] = {{"colour", VK_FORMAT_R8G8B8A8_SRGB, passes::Writes::color}};

struct ScreenFrameOptions {
    graph::Extent extent;
    passes::Nearest nearest{};
    graph::EncodedFormat encoded;  ///< of `encoded`
    graph::ImageDesc atlas{VK_FORMAT_R8_UNORM, {1, 1}};
    std::span<const ScreenTarget> targets;
    const char* name = "screen";  ///< images are kept by it: frames of several sizes want several names
};

/// Bytes that a pass fetches for each primitive, or, if `perPixel`, for each pixel that one covers.
struct Fetch {
    std::uint32_t sphere = 0, cylinder = 0;
    bool perPixel = false;
};

/// When a pass's depth test runs.
enum class DepthTiming : std::uint8_t { none, early, conservative };

/// What vendors' profilers ask of a pass.
struct ScreenPass {
    passes::Writes writes{};
    DepthTiming depth{};
    const char* why = "";        ///< of `depth`
    Fetch binning;               ///< positions alone, to find a primitive's tiles
    Fetch shading;               ///< what visible primitives need after that
    const char* precision = "";  ///< what may be 16 bits wide, and what must not
};

struct ScreenFrame {
    graph::Graph graph{"screen"};
    graph::Image depth;
    graph::Image nearest;  ///< encoded depth or primitive numbers; `fragdepth`: depth itself
    graph::Image atlas;    ///< imported
    std::vector<graph::Image> targets;
    std::vector<ScreenPass> passes;  ///< by Graph::passes()
};

/// What a pass reads beside its streams.
struct ScreenInputs {
    graph::Image atlas, nearest;
    bool nearestIsTexture = false;  ///< it is complete, and sampled rather than kept by the pass
};
/// Gives the function that records a pass; an empty one if the graph is only looked at.
using ScreenRecord = std::function<graph::Record(passes::Writes, const ScreenInputs&)>;

/// Declares the frame: opaque prepass, the pass that finds what is nearest (none with `fragdepth`), and one pass for
/// every target. Targets are not marked as outputs: what becomes of them is the caller's to declare.
ScreenFrame screenFrame(const ScreenFrameOptions& options, const ScreenRecord& record = {});

/// The same frame as the paper arranged it on OpenGL ES 2: prepass and depth texture in one framebuffer, then the
/// picture in another, which samples the full-screen depth texture. Three 8-bit channels encode depth, and 16 bits of
/// hardware depth are what that interface promises.
graph::Graph paperFrame(graph::Extent extent);

/// "none", "early" or "conservative"
const char* depthTimingName(DepthTiming timing);

/// The path of shading for a way to find the nearest surface; `automatic` counts as `encoded`.
passes::Nearest nearestOf(Visibility visibility);

}  // namespace nacre
