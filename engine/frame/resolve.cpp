#include "engine/frame/resolve.h"

#include "engine/frame/record.h"
#include "engine/passes/read_back.h"
#include "engine/tiles/lanes/lane_passes.h"

namespace nacre {

namespace {

/// Copies all pixels unchanged, from words of a buffer.
void declareCopy(Frame& f, graph::Image picture, graph::Extent extent, const PictureImage& to) {
    const vk::ImageSubresourceLayers color(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
    const vk::Extent3D size(extent.width, extent.height, 1);
    f.graph.transfer("picture").copiesTo(picture).copiesFrom(f.numbers).record(
        [=, &to, words = f.numbers](gpu::PassContext& c) {
            c.commands.copyBufferToImage(c.buffer(words), c.image(picture), vk::ImageLayout::eTransferDstOptimal,
                                         vk::BufferImageCopy(0, to.tiles->rowPixels(), 0, color, {}, size));
        });
    f.graph.output(picture);
}

/// Shades samples that are numbers of spheres.
void declareShadedSamples(Frame& f, const FrameShape& shape, const PictureImage& to) {
    const PictureEnd& end = shape.picture;
    std::optional<graph::Clear> clear;
    if (end.first) clear = graph::Clear{0.0f};
    graph::PassBuilder pass = f.graph.graphics("picture, shaded");
    f.lit(pass).reads(f.numbers);
    if (f.finer) pass.samples(*f.finer);
    pass.color(*f.picture, clear)
        .record(records(f, [extent = shape.extent, atlas = f.atlas, mask = f.finer, &to](
                               gpu::PassContext& c, const passes::SceneView& scene) {
            passes::shadeSamples(c, scene, {c.view(atlas), mask ? std::optional(c.view(*mask)) : std::nullopt}, extent,
                                 to.place);
        }));
    f.graph.output(*f.picture);
}

}  // namespace

void declareResolve(Frame& f, const FrameShape& shape, const PictureImage& to) {
    if (shape.drawsIntoPicture()) {
        f.picture = f.targets[0];
        return f.graph.output(*f.picture);
    }
    const PictureEnd& end = shape.picture;
    graph::Image picture = f.graph.importImage("picture", end.image, passes::kTextureState, end.first);
    f.picture = picture;
    if (end.masked)
        f.finer = f.graph.importImage("finer pixels", {VK_FORMAT_R8_UNORM, end.image.extent}, passes::kTextureState);
    if (shape.choice.shadedInPicture()) return declareShadedSamples(f, shape, to);
    std::optional<graph::Image> drawn;
    if (!shape.choice.shadedByCompute()) drawn = f.targets[0];
    if (end.first && end.samples == 1) return declareCopy(f, picture, end.image.extent, to);
    std::optional<graph::Clear> clear;
    if (end.first) clear = graph::Clear{0.0f};
    graph::PassBuilder pass = f.graph.graphics("picture");
    drawn ? pass.samples(*drawn) : pass.reads(f.numbers);
    if (f.finer) pass.samples(*f.finer);
    const passes::Resolving how{end.samples, end.image.format == VK_FORMAT_R8G8B8A8_UNORM, end.masked};
    pass.color(picture, clear).record([=, &to, mask = f.finer](gpu::PassContext& c) {
        passes::Resolved what;
        drawn ? void(what.image = c.view(*drawn)) : void(what.tiles = to.tiles);
        if (mask) what.mask = c.view(*mask);
        passes::resolve(c, how, to.place, what);
    });
    f.graph.output(picture);
}

}  // namespace nacre
