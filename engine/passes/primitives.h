#pragma once
// What the passes over the scene's primitives have in common: streams, copies, sets and the draws.

#include "engine/gpu/execute.h"
#include "engine/graph/encoded_format.h"
#include "engine/passes/plates.h"
#include "engine/passes/scene_view.h"

namespace nacre::passes {

/// A fragment stage as it is, and counting what it shades.
struct Stage {
    gpu::ShaderWords plain, counting;
    gpu::ShaderWords of(const SceneView& view) const { return view.fragments ? counting : plain; }
};

/// Where a pass finds the nearest depth of a pixel.
enum class NearestFrom : std::uint8_t {
    depthBuffer,      ///< by the depth test alone
    inputAttachment,  ///< what an earlier subpass left
    texture,          ///< the same, where it left the tile
    ownAttachment,    ///< which the pass itself keeps, in raster order
};

/// How depth is encoded there.
struct Encoding {
    int channels = 1, steps = 0;
    Encoding() = default;  ///< one float channel: depth itself
    explicit Encoding(const graph::EncodedFormat& format) : channels(format.channels), steps(format.steps) {}
};

/// What a pass reads beside its streams.
struct Reads {
    NearestFrom from = NearestFrom::depthBuffer;
    vk::ImageView atlas, nearest;
};

/// Both stages of a pass for one kind of primitive.
struct Shaders {
    gpu::ShaderWords vertex;
    Stage fragment;
};

/// What a pass does to each primitive.
struct PrimitivePass {
    bool looks = false;            ///< stream B is fetched, too
    const Reads* reads = nullptr;  ///< null: none
    Encoding encoding{};
    gpu::DepthUse depth = gpu::DepthUse::test;
    gpu::Blend blend = gpu::Blend::replace;
    std::uint32_t colorsWritten = 1;
    const Plate* plate = nullptr;  ///< drawn instead of impostors
    bool streams = false;          ///< the fragment stage reads the streams, too
    float rim = 0;                 ///< width of what is drawn about a primitive, Å at z = 0; 0: its contour line's
};

enum class Primitive : std::uint8_t { sphere, cylinder, triangle };

/// Draws the scene's primitives of a kind, all copies.
void drawPrimitives(gpu::PassContext& context, const SceneView& view, Primitive primitive, const Shaders& shaders,
                    const PrimitivePass& pass);

/// Instances of one call: more make Mali-G71 and some PowerVR lose the device (measured by others: 2^14 to 2^16).
constexpr std::uint32_t kMostInstances = 512;

/// What every stage that knows the view must know of it, and, if it shades, of light.
/// @param rim  of PrimitivePass
void setGeometryConstants(gpu::Specialization& constants, const SceneView& view, float rim = 0);
void setShadingConstants(gpu::Specialization& constants, const SceneView& view);

/// The shadow map, or what stands for it where there is none.
vk::DescriptorImageInfo shadowOf(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas);

/// Binds the counter of this pass as set 1, if the view counts.
void bindCounter(gpu::PassContext& context, const SceneView& view, const gpu::Layout& layout,
                 vk::PipelineBindPoint point = vk::PipelineBindPoint::eGraphics);

}  // namespace nacre::passes
