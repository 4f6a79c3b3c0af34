#pragma once
// Shared by the passes over the scene's primitives: streams, copies, sets and draws.

#include <optional>

#include "engine/gpu/counting_shader.h"
#include "engine/gpu/execute.h"
#include "engine/graph/encoded_format.h"
#include "engine/passes/output.h"
#include "engine/passes/plates.h"
#include "engine/passes/scene_view.h"

namespace nacre::passes {

/// A stage that shades fragments.
struct Stage {
    gpu::ShaderWords plain;
    /// As it is, or counting its fragments.
    gpu::ShaderWords of(const SceneView& view) const { return view.fragments ? gpu::countingShader(plain) : plain; }
};
#define NACRE_STAGE(name) \
    nacre::passes::Stage { shaders::name }

/// Encoding of depth in an attachment.
struct Encoding {
    int channels = 1, steps = 0;
    Encoding() = default;  ///< one float channel: depth itself
    explicit Encoding(const graph::EncodedFormat& format) : channels(format.channels), steps(format.steps) {}
};

/// Inputs of a pass besides its streams.
struct Reads {
    NearestFrom from = NearestFrom::depthBuffer;
    vk::ImageView atlas, nearest;
};

/// Both stages of a pass for one kind of primitive.
struct Shaders {
    gpu::ShaderWords vertex;
    Stage fragment;
};

/// The shaders of a pass per kind; none for kinds that it skips.
struct PrimitiveShaders {
    Shaders sphere, cylinder, triangle;
};

/// Variants for GPUs whose vertex outputs go through memory. The vertex stage passes a primitive's number, at most 16
/// bytes in all, and the fragment stage fetches the rest. None where a pass has no such variant.
struct FetchedShaders {
    Shaders sphere, triangle;
};

/// A pass over the scene's primitives.
struct GeometryPass {
    PrimitiveShaders shaders;
    FetchedShaders fetched{};
    bool looks = false;   ///< also fetch stream B
    bool lights = false;  ///< shades without it
    std::optional<Reads> reads{};
    Encoding encoding{};
    gpu::DepthUse depth = gpu::DepthUse::test;
    gpu::Blend blend = gpu::Blend::replace;
    std::uint32_t colorsWritten = 1;
    bool plates = false;     ///< draw spheres as plates, not impostors
    bool streams = false;    ///< the fragment stage also reads the streams
    bool distances = false;  ///< numbers of primitives come with their Z
    float rim = 0;           ///< width of the rim around a primitive, Å at z = 0; 0: that of its outline
};

enum class Primitive : std::uint8_t { sphere, cylinder, triangle };

/// Draws the scene's primitives, all copies.
void draw(gpu::PassContext& context, const SceneView& view, const GeometryPass& pass);
/// Requests the pipelines, and those for the next shapes of a zoom.
void want(gpu::PipelineContext& context, const SceneView& view, const GeometryPass& pass);

/// Maximum of instances per call: more can cause device loss on Mali-G71 and some PowerVR (others measured 2^14 to
/// 2^16).
constexpr std::uint32_t kMostInstances = 512;

/// Whether some spheres are ellipsoids. @param octants  as SceneView::octants
void setEllipsoids(gpu::Specialization& constants, const SceneBuffers& scene, int octants = 1);

/// Sets the constants of the view and, for stages that shade, of light. @param rim  GeometryPass::rim
void setGeometryConstants(gpu::Specialization& constants, const SceneView& view, float rim = 0);
void setShadingConstants(gpu::Specialization& constants, const SceneView& view);

/// The shadow map, or a placeholder without shadows.
vk::DescriptorImageInfo describeShadow(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas);

/// Binds the counter of this pass as set 1, if the view counts.
void bindCounter(gpu::PassContext& context, const SceneView& view, const gpu::Layout& layout,
                 vk::PipelineBindPoint point = vk::PipelineBindPoint::eGraphics);

}  // namespace nacre::passes
