#pragma once
// `nacre plan`: the screen frame planned for a GPU, compared with the same frame unmerged and the paper's arrangement.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/cli/options.h"
#include "engine/frame/choose.h"
#include "engine/frame/frame.h"
#include "engine/frame/geometry.h"
#include "engine/frame/pass_notes.h"
#include "engine/graph/capability_sets.h"

namespace nacre::app {

/// Additional cost of a single effect.
struct EffectCost {
    std::string option;               ///< without dashes
    const char* visibility;           ///< path of the frame with the effect
    std::vector<std::string> passes;  ///< additional passes
    std::uint32_t samples;            ///< per pixel of a picture where colours change, in such a frame
    std::int64_t loaded, stored;      ///< bytes per frame
    std::int64_t tileBytes;           ///< per pixel
};

/// A window at rest: each of its frames adds a sample per pixel to a sum, and shows it.
struct RestPlan {
    std::uint32_t renderPasses = 0, tileBytesPerPixel = 0;
    graph::Traffic traffic, unmerged;
};

struct PlanReport {
    std::string caps;  ///< name of the capability set or device
    graph::PlanCaps plannedWith;
    std::vector<Decision> decisions;  ///< how the frame is drawn, and why
    FrameChoice choice;
    std::span<const graph::Fact> facts;  ///< empty for a real device
    graph::Extent extent;
    Frame frame;
    graph::Plan plan, unmerged;
    graph::Graph paperGraph{""};
    graph::Plan paper;
    MotionSamples motion{};                    ///< of a window's frames in motion
    std::optional<RestPlan> rest{};            ///< none for two eyes and debug views
    std::uint32_t samples = 1;                 ///< per pixel of a picture where colours change
    std::vector<PassGeometry> geometry{};      ///< of the input's scene
    std::vector<std::uint64_t> vertexBytes{};  ///< of its render passes that draw primitives
    graph::Traffic forLimit{};                 ///< traffic that the limit of vertex outputs adds
    std::vector<MeshLevelCount> meshLevels{};
    std::vector<CopyLevelCount> copyLevels{};
    std::vector<EffectCost> costs{};  ///< of active effects
    bool explained = false;           ///< the text lists all decisions

    /// The reason for the path.
    const std::string& why() const { return decisions.front().why; }
};

/// @throws Error if there is no such device, or it cannot encode depth or take samples as requested
PlanReport planReport(const PlanOptions& options);

std::string planText(const PlanReport& report);
/// The keys are stable: snake_case, bytes as whole numbers.
std::string planJson(const PlanReport& report);

/// How a subpass uses an image: "depth" "test".
struct NamedUse {
    std::string image, how;
    bool writes = false;
};
std::vector<NamedUse> listUses(const PlanReport& report, const graph::RenderPassPlan& pass,
                               const graph::Subpass& subpass);
/// Name of a pass's resource.
const std::string& resourceName(const graph::Graph& graph, const graph::Use& use);
/// "opaque prepass + depth encoding"
std::string joinNames(const graph::Graph& graph, const graph::Subpass& subpass);
std::string joinNames(const graph::Graph& graph, const graph::RenderPassPlan& pass);
/// "early tests", "colour output", ...
std::vector<std::string> stageNames(VkPipelineStageFlags stages);
/// Bytes of an image: all pixels, samples and layers.
std::uint64_t countBytes(const graph::ImageDecl& image);

}  // namespace nacre::app
