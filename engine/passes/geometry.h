#pragma once
// What the geometry passes have in common: pipelines of every variant, made when first asked for, and drawing.

#include <map>
#include <tuple>

#include "engine/graph/execute.h"
#include "engine/passes/scene_buffers.h"
#include "shaders/common/layout.h"

namespace nacre::passes {

enum class Primitive : std::uint8_t { sphere, cylinder };

/// What a geometry pass writes.
enum class Writes : std::uint8_t {
    plates,    ///< depth of opaque plates
    encoded,   ///< encoded depth, MIN blend
    depth,     ///< nearest depth alone
    color,
    surface,   ///< normal and Z
    identity,  ///< atom and occlusion
};

/// How a shading pass learns whether a hit is the nearest.
enum class Nearest : std::uint8_t { encoded, fragdepth };

class Geometry {
public:
    Geometry(const gpu::Device& device, const gpu::EncodedFormat& encoded);

    /// Draws the scene's spheres and cylinders (plates: spheres alone).
    /// @param textures set made by textureSet(); null for passes that read none
    void draw(graph::PassContext& context, const SceneBuffers& scene, Writes writes, Nearest nearest, bool perspective,
              const layout::ViewConstants& view, vk::DescriptorSet textures = {});

    /// The atlas and, for `encoded`, the nearest depth.
    vk::DescriptorSet textureSet(graph::PassContext& context, vk::ImageView atlas, Nearest nearest,
                                 vk::ImageView encodedDepth);

private:
    using Key = std::tuple<Primitive, Writes, Nearest, bool, bool, VkRenderPass, std::uint32_t>;

    vk::Pipeline pipeline(graph::PassContext& context, Primitive primitive, Writes writes, Nearest nearest,
                          bool perspective);
    const gpu::Layout& layoutOf(Writes writes, Nearest nearest, bool sampled) const;

    const gpu::Device& device_;
    gpu::EncodedFormat encoded_;
    gpu::Layout plain_, atlasOnly_, inputs_, sampled_;
    vk::raii::Sampler linear_, nearest_;
    std::map<Key, vk::raii::Pipeline> pipelines_;
};

}  // namespace nacre::passes
