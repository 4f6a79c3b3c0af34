#pragma once
// A frame: its graph, and the images and buffers that its passes share. frame.cpp declares it from a choice; the files
// of paths/ and effects/ declare and record the passes.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/frame/choose.h"
#include "engine/graph/graph.h"
#include "engine/passes/output.h"

namespace nacre::passes {
struct SceneView;
}

namespace nacre {

/// State of a window's image before and after a frame.
inline constexpr graph::State kWindowState{VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, 0,
                                           VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};

/// A picture that the frame makes.
struct ScreenTarget {
    const char* image;
    VkFormat format;
    passes::Output output;
    const char* pass;  ///< name of the pass that makes it
    graph::Clear clear{0.0f};
    const graph::State* lent = nullptr;  ///< of an imported image, before and after the frame; null: the frame makes it
};

/// The targets of a choice, except those of windows.
std::span<const ScreenTarget> screenTargets(const FrameChoice& choice);

/// Whether `raster-order` settles depth and shades in one pass: colour and depth together fit every tile.
bool settlesWhileShading(std::span<const ScreenTarget> targets);

/// Composites a background over white, for windows and headsets, which are opaque.
graph::Clear opaqueClear(const std::array<float, 4>& background);

/// How a frame ends in the image of its picture.
struct PictureEnd {
    graph::ImageDesc image{};
    bool first = true;          ///< nothing is in it yet
    bool masked = false;        ///< only some pixels are replaced
    std::uint32_t samples = 1;  ///< n: n x n pixels of the frame are one of it
    friend bool operator==(const PictureEnd&, const PictureEnd&) = default;
};

/// Everything that decides how a frame is declared and planned.
struct FrameShape {
    FrameChoice choice;
    graph::Extent extent;
    graph::ImageDesc atlas{VK_FORMAT_R8_UNORM, {1, 1}};
    std::span<const ScreenTarget> targets;
    const char* name = "screen";   ///< key of its kept images: frames of several sizes need several names
    PictureEnd picture{};          ///< for endings in a picture's image, and through the lens
    graph::Extent window{};        ///< its image's size, for endings in a window
    graph::ImageDesc density{};    ///< of a foveated frame's map
    bool overlay = false;          ///< the window has an overlay
    bool eye = false;              ///< it draws one of two eyes that the window's sum shows
    std::uint32_t listRounds = 1;  ///< in which tiles are drawn, where the device lists their primitives
    bool merge = true, transient = true;

    /// Whether the frame's target is the picture's image itself.
    bool drawsIntoPicture() const {
        return (choice.ending == Ending::picture || choice.ending == Ending::pictureAndHost) && picture.first &&
               picture.samples == 1 && !choice.shadedByCompute();
    }
};
bool operator==(const FrameShape& a, const FrameShape& b);

/// The scene that a frame's passes currently record: a frame is declared once and shows many scenes.
struct ShownScene {
    const passes::SceneView* scene = nullptr;
};

struct Frame {
    graph::Graph graph{"screen"};
    std::shared_ptr<const ShownScene> shown;  ///< null: the frame is only planned, and its passes record nothing
    // On every path:
    graph::Image depth;                            ///< hardware depth
    graph::Image nearest;                          ///< encoded depth or primitive numbers; `fragdepth`: depth itself
    std::optional<graph::EncodedFormat> encoding;  ///< of `nearest`; none: the depth buffer has the nearest depth
    graph::Image atlas;                            ///< imported
    std::optional<graph::Image> shadow;            ///< what the light sees
    std::optional<graph::Image> density;           ///< imported: fragments for each part of the picture
    std::vector<graph::Image> targets;             ///< none where compute or the resolve shades `numbers`
    std::optional<graph::Image> samples;           ///< several per pixel; the first target is their mean
    // Translucent primitives:
    std::vector<graph::Image> layers;          ///< numbers of the nearest layer first
    std::vector<graph::Image> layerDepths;     ///< their depth
    graph::Image restColors, restDepths;       ///< sums over further layers: weighted colours, optical depth
    std::optional<graph::Buffer> layerColors;  ///< of all layers, where compute shades them; imported
    // Of `tiles`, imported:
    std::optional<graph::Buffer> entries;  ///< where the device makes the lists: their entries in any order
    std::optional<graph::Buffer> lists;    ///< and the lists
    graph::Buffer numbers;                 ///< of primitives, or their colours
    std::optional<graph::Buffer> edges;    ///< for edges: numbers if `numbers` are colours, else edge colours
    graph::Buffer edgePixels{};            ///< list of edge pixels
    // Of the ending:
    std::vector<graph::Buffer> pixels;    ///< imported, of targets that the host reads
    std::optional<graph::Image> picture;  ///< imported: the image that the picture ends in
    std::optional<graph::Image> finer;    ///< imported: the mask, if only some pixels are replaced
    std::optional<graph::Image> sum;      ///< imported, of a window: the sum of its samples

    /// A pass that draws what the picture shows, by the density map if there is one.
    graph::PassBuilder graphics(const char* name, graph::SourceLine line = graph::SourceLine::here());
    /// Makes the pass sample the atlas, and the shadow map if there is one. @returns the pass
    graph::PassBuilder& lit(graph::PassBuilder& pass) const;
    /// Makes the pass draw to a target with the choice's samples per pixel. The pass of the first share creates and
    /// clears the image. @returns the pass
    graph::PassBuilder& draw(graph::PassBuilder& pass, const ScreenTarget& target, const FrameShape& shape,
                             const graph::Share& share);
    /// The image of a target.
    graph::Image& add(const ScreenTarget& target, const FrameShape& shape);
};

/// Clears only in the pass of the first share: the others continue its work.
inline std::optional<graph::Clear> clearFirst(const graph::Share& share, const graph::Clear& clear) {
    if (share.index > 0) return {};
    return clear;
}

/// Declares the passes of a shape's scene. The caller declares how the targets are used.
/// @param shown  null: the frame is only planned
Frame declareFrame(const FrameShape& shape, std::shared_ptr<const ShownScene> shown = nullptr);

/// The frame as the paper built it on OpenGL ES 2: prepass and depth texture in one framebuffer, then the picture in
/// another that samples the full-screen depth texture. Depth is encoded in three 8-bit channels; hardware depth has 16
/// bits, the minimum of OpenGL ES 2.
graph::Graph paperFrame(graph::Extent extent);

}  // namespace nacre
