#pragma once
// What the passes over the scene's primitives have in common: streams, copies, sets and the draws.

#include <optional>

#include "engine/gpu/execute.h"
#include "engine/graph/encoded_format.h"
#include "engine/passes/output.h"
#include "engine/passes/plates.h"
#include "engine/passes/scene_view.h"

namespace nacre::passes {

/// A fragment stage as it is, and counting what it shades.
struct Stage {
    gpu::ShaderWords plain, counting;
    gpu::ShaderWords of(const SceneView& view) const { return view.fragments ? counting : plain; }
};
/// By the name of the first (shaders/shaders.cmake).
#define NACRE_STAGE(name) \
    nacre::passes::Stage { shaders::name, shaders::name##Counting }

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

/// Those of a pass; none for what it leaves out.
struct PrimitiveShaders {
    Shaders sphere, cylinder, triangle;
};

/// A pass over the scene's primitives.
struct GeometryPass {
    PrimitiveShaders shaders;
    bool looks = false;  ///< stream B is fetched, too
    std::optional<Reads> reads{};
    Encoding encoding{};
    gpu::DepthUse depth = gpu::DepthUse::test;
    gpu::Blend blend = gpu::Blend::replace;
    std::uint32_t colorsWritten = 1;
    bool plates = false;   ///< of spheres, instead of impostors
    bool streams = false;  ///< the fragment stage reads the streams, too
    float rim = 0;         ///< width of what is drawn about a primitive, Å at z = 0; 0: its contour line's
};

enum class Primitive : std::uint8_t { sphere, cylinder, triangle };

/// Draws the scene's primitives, all copies.
void draw(gpu::PassContext& context, const SceneView& view, const GeometryPass& pass);
/// Asks for the pipelines of that, and for those that a zoom goes over to.
void want(gpu::PipelineContext& context, const SceneView& view, const GeometryPass& pass);

/// Instances of one call: more make Mali-G71 and some PowerVR lose the device (measured by others: 2^14 to 2^16).
constexpr std::uint32_t kMostInstances = 512;

/// What every stage that knows the view must know of it, and, if it shades, of light.
/// @param rim  of GeometryPass
void setGeometryConstants(gpu::Specialization& constants, const SceneView& view, float rim = 0);
void setShadingConstants(gpu::Specialization& constants, const SceneView& view);

/// The shadow map, or what stands for it where there is none.
vk::DescriptorImageInfo shadowOf(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas);

/// Binds the counter of this pass as set 1, if the view counts.
void bindCounter(gpu::PassContext& context, const SceneView& view, const gpu::Layout& layout,
                 vk::PipelineBindPoint point = vk::PipelineBindPoint::eGraphics);

}  // namespace nacre::passes
