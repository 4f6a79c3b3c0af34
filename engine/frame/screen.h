#pragma once
// Declares the screen frame: its images and passes. The renderer draws this graph and `nacre plan` prints it.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/device_options.h"
#include "engine/effects.h"
#include "engine/frame/recorder.h"
#include "engine/graph/encoded_format.h"
#include "engine/graph/graph.h"
#include "engine/results.h"

namespace nacre {

/// A picture that the frame makes.
struct ScreenTarget {
    const char* image;
    VkFormat format;
    passes::Output output;
    const char* pass;  ///< name of the pass that makes it
    graph::Clear clear{0.0f};
    bool window = false;  ///< it is the window's image, to be presented
};

/// State of a window's image before and after a frame.
constexpr graph::State kWindowState{VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, 0, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};

/// The target of an application.
constexpr ScreenTarget kScreenTargets[] = {
    {"colour", VK_FORMAT_R8G8B8A8_SRGB, passes::Output::color, "impostor colour"}};
/// As above where shaders apply the sRGB coding: the bytes are the same.
constexpr ScreenTarget kCodedTargets[] = {
    {"colour", VK_FORMAT_R8G8B8A8_UNORM, passes::Output::color, "impostor colour"}};

/// Draws depth as seen from the light.
constexpr const char* kShadowPass = "shadow map";
/// Draws effects that compare a pixel's nearest primitive with its neighbours'.
constexpr const char* kRimPass = "lines and halos";

/// Draw translucent triangles; numbered from the nearest layer.
constexpr const char* kTranslucentLayer = "translucent layer ";
constexpr const char* kTranslucentColor = "translucent colour ";
/// Translucent layers per pixel: the nearest ones in front of opaque surfaces.
constexpr std::uint32_t kTranslucentLayers = 2;

struct ScreenOptions {
    graph::Extent extent;
    Visibility visibility = Visibility::encoded;  ///< not `automatic`
    graph::EncodedFormat encoded;                 ///< for `encoded`
    graph::ImageDesc atlas{VK_FORMAT_R8_UNORM, {1, 1}};
    std::span<const ScreenTarget> targets;
    bool prepass = true;                  ///< false: plates would reject nothing on this path (graph::platesReject)
    const char* name = "screen";          ///< images are kept by it: frames of several sizes want several names
    bool shadedByTiles = false;           ///< `tiles`: compute shades, too: coded colour, no target
    bool edges = false;                   ///< of `tiles`: they are drawn from more samples than one
    bool edgesPlaced = false;             ///< of these: the host has listed their pixels
    bool edgesAlone = false;              ///< of those: no other pixel is shaded
    bool rims = false;                    ///< of `deferred`, and of `tiles` that shade: halos, or lines by groups
    std::uint32_t shadowPixels = 0;       ///< across the map of what the light sees; 0: there are no shadows
    std::uint32_t translucentLayers = 0;  ///< over the first target, which is colour; 0: all is opaque
    std::uint32_t samples = 1;            ///< of a pixel, for a target whose colour is resolved to it
    bool layersByTiles = false;           ///< of `tiles`: compute finds them, too
    bool intoPicture = false;             ///< the target is the image that the picture ends in
};

/// Primitives that a view submits, and their size in the picture.
struct SceneCounts {
    std::uint64_t spheres = 0, cylinders = 0, triangles = 0;  ///< in all copies
    double radiusPixels = 0;                                  ///< mean radius of the spheres
    bool flat = false;                                        ///< no impostor leans
    std::uint64_t translucent = 0;                            ///< triangles beside the others, which one looks through
    std::vector<MeshLevelCount> meshLevels{};
    std::vector<CopyLevelCount> copyLevels{};
    TileCounts lists{};  ///< tile lists
};

struct ScreenFrame {
    graph::Graph graph{"screen"};
    graph::Image depth;                         ///< hardware depth
    graph::Image nearest;                       ///< encoded depth or primitive numbers; `fragdepth`: depth itself
    graph::Image atlas;                         ///< imported
    graph::Buffer numbers;                      ///< imported, of `tiles`: numbers of primitives, or their colours
    std::optional<graph::Buffer> edges;         ///< imported, of `tiles`: what they need beside that
    std::optional<graph::Image> shadow;         ///< what the light sees
    std::optional<graph::Image> samples;        ///< that the first target is the mean of
    std::vector<graph::Image> targets;          ///< none where compute shades: `numbers` are the picture
    std::vector<graph::Image> layers;           ///< numbers of translucent triangles, of the nearest first
    std::optional<graph::Buffer> layerNumbers;  ///< the same where tiles find them, imported
    graph::Buffer edgePixels{};                 ///< imported, where `edges` are: their pixels
    std::vector<graph::Buffer> pixels;          ///< imported, of targets that the host reads
    std::optional<graph::Image> picture;        ///< imported: the image that the picture ends in
    std::optional<graph::Image> finer;          ///< imported, if only some pixels are replaced: which
    bool intoPicture = false;                   ///< as ScreenOptions has it
    std::optional<graph::Image> sum;            ///< imported, of a window: of its picture's samples

    /// The pass samples the shadow map. @returns the pass
    graph::PassBuilder& lit(graph::PassBuilder& pass) const;
    /// The image of a target, which a pass clears and draws to, by `samples` of each pixel. @returns the pass
    graph::PassBuilder& draw(graph::PassBuilder& pass, const ScreenTarget& target, const ScreenOptions& options);
    /// The image of a target. @returns it
    graph::Image add(const ScreenTarget& target, graph::Extent extent);
};

/// Why a frame with these effects has one sample of a pixel, whatever the device can. Empty: it can have more.
std::string lacksSamples(const Effects& effects, bool translucent);

/// Declares the frame. Targets are not marked as outputs: what becomes of them is the caller's to declare.
/// @param recorder  what the passes record; by default nothing: the frame is only looked at
ScreenFrame screenFrame(const ScreenOptions& options, const Recorder& recorder = {});

/// The `tiles` path: compute finds the nearest primitives per tile, from lists in depth order; then every covered pixel
/// is shaded once. Draws no triangles except those that bound covered areas. Edges: samples from the same lists.
void declareTiles(ScreenFrame& frame, const ScreenOptions& options, const Recorder& draw);

/// The frame as the paper built it on OpenGL ES 2: prepass and depth texture in one framebuffer, then the picture in
/// another that samples the full-screen depth texture. Depth is encoded in three 8-bit channels; hardware depth has 16
/// bits, the minimum of OpenGL ES 2.
graph::Graph paperFrame(graph::Extent extent);

}  // namespace nacre
