#pragma once
// What the geometry passes have in common: pipelines of every variant, made when first asked for, and drawing.

#include <map>
#include <tuple>
#include <vector>

#include "engine/gpu/execute.h"
#include "engine/passes/placed_copies.h"
#include "engine/passes/plates.h"
#include "engine/passes/scene_buffers.h"
#include "engine/passes/shader_table.h"
#include "shaders/common/layout.h"

namespace nacre::passes {

/// Everything that one pass draws with.
struct Draw {
    Writes writes{};
    Nearest nearest{};
    bool perspective = false;
    layout::ViewConstants view{};
    int quarterTurns = 0;  ///< as in View
    const PlacedCopies* copies = nullptr;
    const gpu::Buffer* copyRows = nullptr;      ///< PlacedCopies::rows on the device, for `deferred` shading
    PlateShape plates = PlateShape::automatic;  ///< of Writes::plates
    ImpostorShape impostor = ImpostorShape::automatic;
    double radiusPixels = 0;               ///< mean radius of the spheres in the picture
    const gpu::Buffer* counter = nullptr;  ///< counts shaded fragments at `counterOffset`, bytes
    vk::DeviceSize counterOffset = 0;
};

/// What a shading pass reads.
struct ShadingInputs {
    vk::ImageView atlas;
    vk::ImageView nearest;   ///< encoded depth or primitive numbers; unused by `fragdepth`
    bool asTexture = false;  ///< `nearest` is complete and read as a texture
};

class Geometry {
public:
    explicit Geometry(const gpu::Device& device);

    /// Draws the scene's spheres and cylinders; plates for spheres alone; one triangle for `deferred` shading.
    void draw(gpu::PassContext& context, const SceneBuffers& scene, const Draw& draw, const ShadingInputs& inputs = {});

private:
    using LayoutKey = std::tuple<bool, Nearest, bool, bool>;  // reads, nearest, sampled, counting
    using PipelineKey = std::tuple<ShaderKey, bool, int, std::uint32_t, VkRenderPass, std::uint32_t>;

    const gpu::Layout& layoutOf(const ShaderKey& key);
    vk::Pipeline pipeline(gpu::PassContext& context, const ShaderKey& key, const Draw& draw, std::uint32_t corners,
                          float rim);
    void drawPrimitives(gpu::PassContext& context, const SceneBuffers& scene, const Draw& draw,
                        const ShadingInputs& inputs, Primitive primitive, std::uint32_t corners, float rim = 0);
    void bindSets(gpu::PassContext& context, const SceneBuffers& scene, const ShaderKey& key, const Draw& draw,
                  const ShadingInputs& inputs);

    const gpu::Device& device_;
    vk::raii::Sampler linear_, nearest_;
    std::map<LayoutKey, gpu::Layout> layouts_;
    std::map<PipelineKey, vk::raii::Pipeline> pipelines_;
};

}  // namespace nacre::passes
