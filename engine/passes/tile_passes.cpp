#include "engine/passes/tile_passes.h"

#include <cstddef>

#include "engine/passes/primitives.h"
#include "engine/passes/tile_frame.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

using Type = vk::DescriptorType;
constexpr auto kCompute = vk::ShaderStageFlagBits::eCompute;
constexpr vk::ShaderStageFlags kDraw = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

constexpr Type kTexel = Type::eUniformTexelBuffer, kStorage = Type::eStorageBuffer;
// Shapes, rows of copies, lists; numbers, which are written.
constexpr Type kNearestTexels[] = {kTexel, kTexel, kTexel, kStorage};
constexpr Type kNearestStorage[] = {kStorage, kStorage, kStorage, kStorage};
// Where it shades: looks, atlas, effects and cells of the atlas, too.
constexpr Type kNearestShaded[] = {
    kTexel, kTexel, kTexel, kStorage, kTexel, Type::eCombinedImageSampler, Type::eUniformBuffer, kTexel};
// Atlas, effects, numbers, shapes, rows of copies, looks.
constexpr Type kShadeTexels[] = {Type::eCombinedImageSampler, Type::eUniformBuffer, kTexel, kTexel, kTexel, kTexel};
constexpr Type kShadeStorage[] = {
    Type::eCombinedImageSampler, Type::eUniformBuffer, kStorage, kStorage, kStorage, kStorage};

constexpr vk::VertexInputBindingDescription kSpanBindings[] = {
    {0, sizeof(TileSpanVertex), vk::VertexInputRate::eInstance}};
constexpr vk::VertexInputAttributeDescription kSpanAttributes[] = {
    {0, 0, vk::Format::eR32G32B32A32Sfloat, 0}, {1, 0, vk::Format::eR32G32Uint, offsetof(TileSpanVertex, left)}};

/// The variants of a stage by where its data is and what the scene has.
#define NACRE_TILE_STAGE(name, counting)                                                                      \
    (texels ? (cylinders ? shaders::name##TexelsCylinders##counting : shaders::name##TexelsSpheres##counting) \
            : (cylinders ? shaders::name##StorageCylinders##counting : shaders::name##StorageSpheres##counting))

gpu::ShaderWords nearestShader(bool texels, bool cylinders, bool shaded) {
    if (shaded) return cylinders ? shaders::tileShadedCylinders : shaders::tileShadedSpheres;
    return NACRE_TILE_STAGE(tileNearest, );
}

Stage shadeShader(Output output, bool texels, bool cylinders) {
    switch (output) {
        case Output::surface:
            return {NACRE_TILE_STAGE(tileSurface, ), NACRE_TILE_STAGE(tileSurface, Counting)};
        case Output::identity:
            return {NACRE_TILE_STAGE(tileIdentity, ), NACRE_TILE_STAGE(tileIdentity, Counting)};
        case Output::color:
            break;
    }
    return {NACRE_TILE_STAGE(tileColor, ), NACRE_TILE_STAGE(tileColor, Counting)};
}

/// Sets one binding after another.
class Bindings {
public:
    Bindings(gpu::PassContext& context, vk::DescriptorSet set, std::uint32_t first)
        : context_(context), set_(set), at_(first) {}

    /// As the device reads streams: texels, or storage.
    void read(const gpu::Buffer& buffer, const vk::raii::BufferView& texels) {
        if (!*texels) return store(buffer);
        const vk::BufferView view = *texels;
        write({set_, at_++, 0, 1, kTexel, nullptr, nullptr, &view});
    }
    void read(vk::BufferView view) { write({set_, at_++, 0, 1, kTexel, nullptr, nullptr, &view}); }
    void read(const TileBuffer& b) { read(b.buffer, b.texels); }
    void sample(vk::Sampler sampler, vk::ImageView image) {
        const vk::DescriptorImageInfo info(sampler, image, vk::ImageLayout::eShaderReadOnlyOptimal);
        write({set_, at_++, 0, 1, Type::eCombinedImageSampler, &info});
    }
    void store(const gpu::Buffer& buffer) { whole(buffer, kStorage); }
    void uniform(const gpu::Buffer& buffer) { whole(buffer, Type::eUniformBuffer); }

private:
    void whole(const gpu::Buffer& buffer, Type type) {
        const vk::DescriptorBufferInfo info(*buffer.handle, 0, VK_WHOLE_SIZE);
        write({set_, at_++, 0, 1, type, nullptr, &info});
    }
    void write(const vk::WriteDescriptorSet& write) { context_.device->updateDescriptorSets(write, {}); }

    gpu::PassContext& context_;
    vk::DescriptorSet set_;
    std::uint32_t at_;
};

void setView(gpu::Specialization& constants, const SceneView& view) {
    setGeometryConstants(constants, view);
    constants.set(layout::kCopiesId, view.tiles->copies);
    constants.set(layout::kTilesInBinId, TileLists::kTilesInBin);
}

}  // namespace

void findNearestByTiles(gpu::PassContext& context, const SceneView& view, std::optional<vk::ImageView> atlas) {
    const TileFrame& f = *view.tiles;
    const SceneBuffers& scene = *view.buffers;
    const gpu::TileCaps& caps = context.device.caps().tiles;
    if (f.lists.tiles().empty()) return;
    const std::span<const Type> types = atlas         ? std::span<const Type>(kNearestShaded)
                                        : caps.texels ? kNearestTexels
                                                      : kNearestStorage;
    const gpu::Layout& layout =
        context.pipelines.layout({"nearest primitive by tiles", types, kCompute, sizeof(layout::TileConstants)});
    const gpu::ShaderWords code = nearestShader(caps.texels, scene.cylinderCount > 0, atlas.has_value());
    gpu::ComputePipeline d{context.pass, code, {}, *layout.pipeline};
    setView(d.constants, view);
    if (atlas) setShadingConstants(d.constants, view);
    d.constants.set(layout::kLanesId, caps.lanes);
    context.commands.bindPipeline(vk::PipelineBindPoint::eCompute, context.pipelines.compute(d));
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    Bindings bindings(context, set, 0);
    bindings.read(scene.shapes, scene.shapeTexels);
    bindings.read(f.rows);
    bindings.read(f.words);
    bindings.store(f.numbers.buffer);
    if (atlas) {
        bindings.read(scene.looks, scene.lookTexels);
        bindings.sample(context.pipelines.sampler(vk::Filter::eLinear), *atlas);
        bindings.uniform(*view.effectConstants);
        // Never left unwritten, even where the shader reads none: lavapipe looks at it.
        bindings.read(view.occlusionCells ? view.occlusionCells : *scene.lookTexels);
    }
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout.pipeline, 0, set, {});
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kCompute, 0, f.constants);
    // The floor's limit of workgroups in a row.
    constexpr std::uint32_t kRow = 65535;
    const auto tiles = static_cast<std::uint32_t>(f.lists.tiles().size());
    context.commands.dispatch(std::min(tiles, kRow), (tiles + kRow - 1) / kRow, 1);
}

void shadeTiles(gpu::PassContext& context, const SceneView& view, Output output, vk::ImageView atlas) {
    const TileFrame& f = *view.tiles;
    const SceneBuffers& scene = *view.buffers;
    const bool texels = context.device.caps().tiles.texels;
    if (f.lists.spans().empty()) return;
    const gpu::Layout& layout =
        context.pipelines.layout({"shading by tiles", texels ? kShadeTexels : kShadeStorage, kDraw,
                                  sizeof(layout::TileConstants), view.fragments != nullptr});
    gpu::GraphicsPipeline d = context.pipeline();
    d.detail = "tiles";
    d.vertex = shaders::tileSpanVertex;
    d.fragment = shadeShader(output, texels, scene.cylinderCount > 0).of(view);
    setView(d.constants, view);
    setShadingConstants(d.constants, view);
    d.streams = {kSpanBindings, kSpanAttributes};
    d.layout = *layout.pipeline;
    d.colorsWritten = 1;
    context.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, context.pipelines.graphics(d));
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    Bindings bindings(context, set, 0);
    bindings.sample(context.pipelines.sampler(vk::Filter::eLinear), atlas);
    bindings.uniform(*view.effectConstants);
    bindings.read(f.numbers);
    bindings.read(scene.shapes, scene.shapeTexels);
    bindings.read(f.rows);
    bindings.read(scene.looks, scene.lookTexels);
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
    bindCounter(context, view, layout);
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kDraw, 0, f.constants);
    context.commands.bindVertexBuffers(0, {*f.spans.buffer.handle}, {0});
    context.commands.draw(4, static_cast<std::uint32_t>(f.lists.spans().size()), 0, 0);
}

void copyColors(gpu::PassContext& context, const SceneView& view, graph::Buffer colors, graph::Image image,
                graph::Extent extent) {
    const std::uint32_t pitch = view.tiles->lists.across() * TileLists::kBinPixels;
    const vk::BufferImageCopy all(0, pitch, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                  {extent.width, extent.height, 1});
    context.commands.copyBufferToImage(context.buffer(colors), context.image(image),
                                       vk::ImageLayout::eTransferDstOptimal, all);
}

}  // namespace nacre::passes
