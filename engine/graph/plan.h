#pragma once
// A graph planned for a device: a value that can be compared and printed. Makes no Vulkan calls.

#include <cstdint>
#include <string>
#include <vector>

#include "engine/graph/graph.h"

namespace nacre::graph {

/// How a device handles geometry. Thresholds are a sphere's mean radius in pixels.
struct GeometryCaps {
    bool storesVaryings = false;        ///< vertex outputs go through memory: written once and read once
    double plateOctagons = 0;           ///< from this radius on plates are octagons, below squares
    double octagons = 0;                ///< from this radius on impostors are octagons, below squares
    double domes = 6;                   ///< from this radius on plates are domes of three, and impostors pyramids
    std::uint64_t mostVertexBytes = 0;  ///< vertex outputs of one render pass; 0: no limit
    friend bool operator==(const GeometryCaps&, const GeometryCaps&) = default;
};

/// Whether a fragment that reads its own attachment finds what earlier primitives wrote, in the same draw call too.
enum class RasterOrder : std::uint8_t {
    none,
    assumed,   ///< the driver is known to do so and does not promise it: only if a self-test finds it right
    promised,  ///< VK_EXT_rasterization_order_attachment_access
};

/// Facts about the device that the planner needs. Named sets: capability_sets.h.
struct PlanCaps {
    std::string name;
    bool merge = true;          ///< neighbouring passes may share a render pass
    bool tileSubpasses = true;  ///< input attachments between subpasses stay on the tile
    bool transient = true;      ///< attachments that never leave the tile need no memory
    RasterOrder rasterOrder = RasterOrder::none;
    bool blendsByShader = false;            ///< MIN is a shader after the fragment's own
    bool loadsUniforms = false;             ///< each invocation loads uniforms for itself
    bool conservativeDepth = true;          ///< depth_greater lets the test reject before the fragment shader
    bool storeAll = false;                  ///< store every attachment, to inspect it in a capture
    bool placesSamples = true;              ///< a pixel's samples have the specification's standard positions
    bool storeNone = false;                 ///< VK_EXT_load_store_op_none: a tested depth buffer is not stored again
    std::uint32_t tileBytesPerPixel = 16;   ///< colour + input attachments of one render pass
    std::uint32_t maxColorAttachments = 4;  ///< of one subpass
    std::uint32_t maxInputAttachments = 4;
    std::uint32_t densityTexel = 0;  ///< pixels per side of a fragment density map's texel; 0: it takes no such map
    std::uint32_t maxViews = 6;      ///< that a pass can draw at once (multiview); 1: no more than one
    GeometryCaps geometry;
    friend bool operator==(const PlanCaps&, const PlanCaps&) = default;
};

enum class Load : std::uint8_t { clear, load, dontCare };
enum class Store : std::uint8_t { store, dontCare, none };

struct Attachment {
    std::uint32_t image = 0;  ///< index into Graph::images()
    VkFormat format{};
    std::uint32_t samples = 1;
    Load load{};
    Store store{};
    bool transient = false;
    Clear clear{0.0f};
    VkImageLayout initialLayout{};
    VkImageLayout finalLayout{};
    friend bool operator==(const Attachment&, const Attachment&) = default;
};

/// Indices are into RenderPassPlan::attachments.
struct Subpass {
    std::vector<std::uint32_t> passes;  ///< indices into Graph::passes()
    std::vector<std::uint32_t> colors;
    std::vector<std::uint32_t> inputs;
    std::vector<std::uint32_t> preserve;
    std::int32_t depth = -1;    ///< -1: none
    std::int32_t resolve = -1;  ///< gets the mean of the first colour's samples; -1: none
    bool depthWrite = false;
    bool ordered = false;  ///< attachments used as colour and input are read in raster order
    friend bool operator==(const Subpass&, const Subpass&) = default;
};

struct Dependency {
    std::uint32_t from = 0, to = 0;  ///< subpass, or VK_SUBPASS_EXTERNAL
    VkPipelineStageFlags fromStages{}, toStages{};
    VkAccessFlags fromAccess{}, toAccess{};
    bool byRegion = true;
    friend bool operator==(const Dependency&, const Dependency&) = default;
};

struct RenderPassPlan {
    Extent extent;
    std::uint32_t layers = 1, samples = 1;  ///< samples: of all attachments except resolve targets
    std::int32_t density = -1;              ///< attachment that is its fragment density map; -1: none
    std::uint32_t viewMask = 0;             ///< a bit per layer: each is a view, and one draw call draws all views
    std::vector<Attachment> attachments;
    std::vector<Subpass> subpasses;
    std::vector<Dependency> dependencies;
    std::uint32_t tileBytesPerPixel = 0;  ///< colour and input attachments, all samples; depth beside it
    friend bool operator==(const RenderPassPlan&, const RenderPassPlan&) = default;
};

struct Barrier {
    bool isImage = true;
    std::uint32_t resource = 0;
    State from, to;
    friend bool operator==(const Barrier&, const Barrier&) = default;
};

struct Step {
    PassKind kind{};
    std::vector<Barrier> before;
    std::uint32_t pass = 0;     ///< compute and transfer: index into Graph::passes()
    RenderPassPlan renderPass;  ///< graphics
    friend bool operator==(const Step&, const Step&) = default;
};

struct PlannedImage {
    VkImageUsageFlags usage = 0;
    bool transient = false;
    bool used = false;
    friend bool operator==(const PlannedImage&, const PlannedImage&) = default;
};

/// Bytes of attachments, of whole-image reads and of buffers between passes, per execution.
struct Traffic {
    std::uint64_t loaded = 0, stored = 0;
    friend bool operator==(const Traffic&, const Traffic&) = default;
};

struct Plan {
    std::vector<Step> steps;
    std::vector<Barrier> after;          ///< return imported resources to their state, outputs to the host
    std::vector<PlannedImage> images;    ///< by Graph::images()
    std::vector<Traffic> traffic;        ///< by Graph::images()
    std::vector<Traffic> bufferTraffic;  ///< by Graph::buffers(): between passes
    std::vector<bool> culled;            ///< by Graph::passes()
    std::vector<bool> inputIsSampled;    ///< by Graph::passes(): input attachments became texture reads
    Traffic total;
    friend bool operator==(const Plan&, const Plan&) = default;
};

/// @throws GraphError that names pass and resource
Plan compile(const Graph& graph, const PlanCaps& caps);

/// Maximum tile memory per pixel, without hardware depth.
std::uint32_t tileBytesPerPixel(const Plan& plan);

/// The plan as text: render passes, subpasses, attachments, traffic. Stable: tests compare it.
std::string describe(const Graph& graph, const Plan& plan);

/// Bytes per texel of the formats that the renderer uses. @throws GraphError for any other
std::uint32_t bytesPerTexel(VkFormat format);
bool isDepthFormat(VkFormat format);
/// "RGBA8", "D32F", "R32F", ...
std::string formatName(VkFormat format);

/// Stage, access and layout of a verb in a kind of pass: the one table behind all barriers.
State verbState(Verb verb, PassKind kind);

}  // namespace nacre::graph
