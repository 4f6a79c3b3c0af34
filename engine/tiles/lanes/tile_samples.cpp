// Shades the samples of a picture's block, whose spheres the host found.

#include <array>

#include "engine/settings.h"
#include "engine/tiles/lanes/lane_passes.h"
#include "engine/tiles/lanes/tile_spans.h"
#include "engine/tiles/tile_bindings.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

// Atlas, effects, shadow map; numbers; shapes, rows of copies, looks, cells of the atlas; mask.
constexpr std::array kTexels{kSampled, Type::eUniformBuffer, kSampled, kTexel, kTexel, kTexel, kTexel, kTexel,
                             kSampled};
constexpr auto kBuffers = asStorage(kTexels);

constexpr std::uint32_t kSide = RenderSettings::kBlockSamples;

/// Constants for fragments of the picture, in place of those of the frame.
/// @param shift  from a pixel of the picture to that of the frame
layout::TileConstants inPicture(layout::TileConstants t, const TileSet& tiles, const glm::ivec2& shift) {
    t.axisPixel -= glm::vec2(shift) * static_cast<float>(kSide);
    const std::uint32_t pitch = tiles.across() * TileSet::kBinPixels;
    t.offsets = kSide * (static_cast<std::uint32_t>(shift.y) * pitch + static_cast<std::uint32_t>(shift.x));
    return t;
}

}  // namespace

void shadeSamples(gpu::PassContext& context, const SceneView& view, const SampledSpheres& input, graph::Extent frame,
                  const ResolvePlace& place) {
    static_assert(kSide == 4);  // as in the shader
    const ListedFrame& f = listedFrame(view);
    const SceneBuffers& scene = *view.buffers;
    const bool texels = context.device.caps().tiles.texels;
    if (f.tiles().spans().empty()) return;
    const glm::ivec2 first(place.rect.x, place.rect.y), shift = glm::ivec2(place.x, place.y) - first;
    const gpu::Layout& layout = context.pipelines.layout(
        {"samples of spheres", texels ? kTexels : kBuffers, kDraw, sizeof(layout::TileConstants)});
    gpu::GraphicsPipeline d = context.pipeline();
    d.detail = "samples";
    d.vertex = shaders::tileSpanVertex;
    d.fragment = texels ? shaders::tileSamplesTexels : shaders::tileSamplesStorage;
    d.constants.set(layout::kMaskedId, input.mask.has_value());
    setTileView(d.constants, view);
    setShadingConstants(d.constants, view);
    d.streams = spanStreams();
    d.layout = *layout.pipeline;
    d.colorsWritten = 1;
    bindTiles(context, layout, d, inPicture(f.constants, f.tiles(), shift), [&](TileBindings& to) {
        to.sample(input.atlas);
        to.uniform(*view.effectConstants);
        to.sample(describeShadow(context, view, input.atlas));
        to.read(f.numbers.buffer, f.numbers.quads);
        to.read(scene.shapes, scene.shapeTexels);
        to.read(f.rows);
        to.read(scene.looks, scene.lookTexels);
        // Always written, even if the shader reads none: lavapipe accesses it.
        if (texels)
            to.read(view.occlusionCells ? view.occlusionCells : *scene.lookTexels);
        else
            to.store(scene.looks);
        to.sample(input.mask.value_or(input.atlas));
    });
    context.commands.setViewport(
        0, vk::Viewport(static_cast<float>(-shift.x), static_cast<float>(-shift.y),
                        static_cast<float>(frame.width) / kSide, static_cast<float>(frame.height) / kSide, 0, 1));
    context.commands.setScissor(0, vk::Rect2D({first.x, first.y}, {place.rect.width, place.rect.height}));
    drawSpans(context, f);
}

}  // namespace nacre::passes
