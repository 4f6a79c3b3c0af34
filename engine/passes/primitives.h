#pragma once
// What the passes over the scene's spheres and cylinders have in common: streams, copies, sets and the draws.

#include "engine/gpu/execute.h"
#include "engine/graph/encoded_format.h"
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
    Shaders shaders;
    bool looks = false;            ///< stream B is fetched, too
    const Reads* reads = nullptr;  ///< null: none
    Encoding encoding{};
    gpu::DepthUse depth = gpu::DepthUse::test;
    gpu::Blend blend = gpu::Blend::replace;
    std::uint32_t colorsWritten = 1;
    std::uint32_t corners = 4;  ///< of the polygon; kPyramidCorners: a triangle list
    float rim = 0;              ///< of plates
};
constexpr std::uint32_t kPyramidCorners = 24;

/// The scene's spheres, all copies.
void drawSpheres(gpu::PassContext& context, const SceneView& view, const PrimitivePass& pass);
/// Spheres and cylinders as impostors. The pass's own shaders and corners are not looked at.
void drawImpostors(gpu::PassContext& context, const SceneView& view, PrimitivePass pass, const Shaders& spheres,
                   const Shaders& cylinders);

/// Binds the counter of this pass as set 1, if the view counts.
void bindCounter(gpu::PassContext& context, const SceneView& view, const gpu::Layout& layout);

}  // namespace nacre::passes
