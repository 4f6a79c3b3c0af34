#pragma once
// Shared by the tile passes: bindings of their inputs, and the number of workgroups.

#include <algorithm>

#include "engine/gpu/execute.h"
#include "engine/passes/bindings.h"
#include "engine/passes/primitives.h"
#include "engine/tiles/listed_frame.h"

namespace nacre::passes {

/// Primitives of a scene: spheres alone, with cylinders, or with cylinders and triangles.
enum class TileScene : std::uint8_t { spheres, cylinders, triangles };
inline TileScene tileScene(const SceneBuffers& scene) {
    return scene.triangleCount > 0   ? TileScene::triangles
           : scene.cylinderCount > 0 ? TileScene::cylinders
                                     : TileScene::spheres;
}

/// Variants of a stage, by the scene's primitives and by the location of its data.
#define NACRE_TILE_SCENE(name)                                  \
    (scene == TileScene::triangles   ? shaders::name##Triangles \
     : scene == TileScene::cylinders ? shaders::name##Cylinders \
                                     : shaders::name##Spheres)
#define NACRE_TILE_SHADER(name) (texels ? NACRE_TILE_SCENE(name##Texels) : NACRE_TILE_SCENE(name##Storage))

/// Sets one binding after another.
class TileBindings {
public:
    TileBindings(gpu::PassContext& context, vk::DescriptorSet set) : context_(context), set_(set) {}

    /// Binds streams in the form that the device reads: texel or storage buffers.
    void read(const gpu::Buffer& buffer, const vk::raii::BufferView& texels) {
        if (!*texels) return store(buffer);
        const vk::BufferView view = *texels;
        write({set_, at_++, 0, 1, kTexel, nullptr, nullptr, &view});
    }
    void read(vk::BufferView view) { write({set_, at_++, 0, 1, kTexel, nullptr, nullptr, &view}); }
    void read(const TileBuffer& b) { read(b.buffer, b.texels); }
    void store(const gpu::Buffer& buffer) { whole(buffer, kStorage); }
    void store(vk::ImageView image) {
        const vk::DescriptorImageInfo info({}, image, vk::ImageLayout::eGeneral);
        write({set_, at_++, 0, 1, Type::eStorageImage, &info});
    }
    void uniform(const gpu::Buffer& buffer) { whole(buffer, Type::eUniformBuffer); }
    void sample(vk::ImageView texture) {
        sample({context_.pipelines.sampler(vk::Filter::eLinear), texture, vk::ImageLayout::eShaderReadOnlyOptimal});
    }
    void sample(const vk::DescriptorImageInfo& image) { write({set_, at_++, 0, 1, kSampled, &image}); }

private:
    void whole(const gpu::Buffer& buffer, Type type) {
        const vk::DescriptorBufferInfo info(*buffer.handle, 0, VK_WHOLE_SIZE);
        write({set_, at_++, 0, 1, type, nullptr, &info});
    }
    void write(const vk::WriteDescriptorSet& write) { context_.device->updateDescriptorSets(write, {}); }

    gpu::PassContext& context_;
    vk::DescriptorSet set_;
    std::uint32_t at_ = 0;
};

/// Binds a pass: pipeline, set 0 and push constants. @param write  receives the set's TileBindings
template <typename Push, typename Write>
void bindTiles(gpu::PassContext& context, const gpu::Layout& layout, vk::PipelineBindPoint point, vk::Pipeline pipeline,
               const Push& push, const Write& write) {
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    TileBindings bindings(context, set);
    write(bindings);
    context.commands.bindPipeline(point, pipeline);
    context.commands.bindDescriptorSets(point, *layout.pipeline, 0, set, {});
    context.commands.pushConstants<Push>(*layout.pipeline, point == vk::PipelineBindPoint::eCompute ? kCompute : kDraw,
                                         0, push);
}
template <typename Push, typename Write>
void bindTiles(gpu::PassContext& context, const gpu::Layout& layout, const gpu::ComputePipeline& pipeline,
               const Push& push, const Write& write) {
    bindTiles(context, layout, vk::PipelineBindPoint::eCompute, context.pipelines.compute(pipeline), push, write);
}
template <typename Push, typename Write>
void bindTiles(gpu::PassContext& context, const gpu::Layout& layout, const gpu::GraphicsPipeline& pipeline,
               const Push& push, const Write& write) {
    bindTiles(context, layout, vk::PipelineBindPoint::eGraphics, context.pipelines.graphics(pipeline), push, write);
}

/// @param rim  of GeometryPass
inline void setTileView(gpu::Specialization& constants, const SceneView& view, float rim = 0) {
    setGeometryConstants(constants, view, rim);
    constants.set(layout::kCopiesId, listedFrame(view).copies);
    constants.set(layout::kTilesInBinId, TileSet::kTilesInBin);
}

/// @param count  of workgroups
inline void dispatchTiles(gpu::PassContext& context, std::size_t count) {
    constexpr std::uint32_t kRow = 65535;  // required limit of workgroups per dimension
    const auto groups = static_cast<std::uint32_t>(count);
    context.commands.dispatch(std::min(groups, kRow), (groups + kRow - 1) / kRow, 1);
}

}  // namespace nacre::passes
