// Pictures with more samples where they need them, in one frame or in blocks, and parts of pictures.

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "engine/frame/geometry.h"
#include "engine/frame/lens.h"
#include "engine/frame/picture_frames.h"
#include "engine/passes/read_back.h"
#include "engine/software/tile_lists.h"

namespace nacre {
namespace {

constexpr std::uint32_t kBlockPixels = 384;  ///< a side: 2 million samples and those of their rim
static_assert(kBlockPixels % PictureRect::kStep == 0);

/// Adds a number of each row to that of the same pass.
template <typename Row, typename Number>
void addUp(std::vector<Row>& sum, const std::vector<Row>& more, Number Row::*number) {
    for (const Row& row : more) {
        const auto same = std::ranges::find(sum, row.name, &Row::name);
        if (same == sum.end())
            sum.push_back(row);
        else
            (*same).*number += row.*number;
    }
}

/// Margin around a part, in pixels, that influences it: neighbours for edges, and the reach of outlines and halos.
/// @param more  of passes over the whole picture
std::uint32_t rimOf(const RenderSettings& settings, double more = 0) {
    constexpr std::uint32_t kRim = PictureRect::kStep;
    static_assert(kRim == TileLists::kBinPixels);  // its bins are those of the whole
    const double reach = std::max(settings.effects.contours.width, settings.effects.halos.width) + more;
    return kRim * std::max(static_cast<std::uint32_t>(std::ceil(reach / kRim)), 1u);
}

/// A rectangle of a view with a margin, clamped to the view, and the rectangle's position in it.
std::pair<View, PictureRect> withRim(const View& whole, const PictureRect& part, std::uint32_t rim) {
    const std::uint32_t left = part.x - std::min(part.x, rim), top = part.y - std::min(part.y, rim);
    const std::uint32_t right = std::min(part.x + part.width + rim, whole.width);
    const std::uint32_t bottom = std::min(part.y + part.height + rim, whole.height);
    return {partOf(whole, left, top, right - left, bottom - top),
            {part.x - left, part.y - top, part.width, part.height}};
}

PictureRect wholeOf(graph::Extent image) { return {0, 0, image.width, image.height}; }

}  // namespace

Picture PictureFrames::part(const RenderSettings& settings, const passes::Atlas& atlas, const PictureRect& part) {
    const double reach = hasLens(settings) ? largestCircle(settings) + passes::kLensBlock : 0;
    const auto [view, inner] = withRim(settings.view, part, rimOf(settings, reach));
    return picture(settings, atlas, {view, inner});
}

/// The picture's image, of that size and format from then on.
void PictureFrames::makePicture(const graph::ImageDesc& desc) {
    using Usage = vk::ImageUsageFlagBits;
    if (picture_.image.desc == desc) return;
    executor_.forgetFramebuffers();
    picture_.image = gpu::makeImage(
        device_, desc, Usage::eColorAttachment | Usage::eSampled | Usage::eTransferSrc | Usage::eTransferDst, false,
        "picture");
}

/// How a frame ends in the picture's image. @param shown  of the picture @param samples  as PictureEnd has it
PictureFrames::Ending PictureFrames::inImage(const RenderSettings& settings, const View& shown, Samples samples) {
    const graph::Extent image = imageExtent(shown);
    makePicture({pictureTargets(settings, samples)[0].format, image});
    return {FrameEnd::resolved, {picture_.image.desc}, {wholeOf(image)}};
}

/// The picture's image, as the host reads it.
PictureFrames::Drawn PictureFrames::readPicture() {
    const graph::ImageDesc& desc = picture_.image.desc;
    const std::uint64_t bytes =
        std::uint64_t{desc.extent.width} * desc.extent.height * graph::bytesPerTexel(desc.format);
    Drawn drawn;
    drawn.pixels.push_back(gpu::makeBuffer(device_, bytes, vk::BufferUsageFlagBits::eTransferDst, gpu::Access::readback,
                                           "picture pixels"));
    graph::Graph g("picture");
    const graph::Image image = g.importImage("picture", desc, passes::kTextureState);
    const graph::Buffer buffer = g.importBuffer("picture pixels", bytes);
    passes::readBack(g, image, desc, buffer);
    gpu::Imports imports;
    imports.bind(image, picture_.image);
    imports.bind(buffer, drawn.pixels[0]);
    executor_.run(g, imports);
    drawn.pixels[0].invalidate();
    return drawn;
}

/// Draws a picture with one sample per pixel. @returns where it needs more samples; nothing: in all pixels, as
/// something may lie between their centres
std::optional<FinerPlaces> PictureFrames::coarsePicture(const RenderSettings& settings, const passes::Atlas& atlas,
                                                        const View& view) {
    constexpr double kSmallPixels = 0.75;  // half of a width
    constexpr double kThinLine = 0.34;     // of the widest, as shaders/common/rims.glsl has it
    const double width = settings.effects.contours.width;
    const bool thin = settings.effects.linesByGroups() && kThinLine * width < 1;
    if (view.quarterTurns != 0 || (thin && width < 1)) return {};
    Ending ending = inImage(settings, view, Samples::one);
    ending.end = FrameEnd::coarse;
    ending.finer = settings.effects.rims();  // no path but `deferred` has them beside the device's
    const Drawn drawn = draw(settings, atlas, view, pictureTargets(settings), ending, "coarse screen");
    if (drawn.smallestPixels < kSmallPixels) return {};
    const auto [pixels, rowPixels] = rowsOf(drawn, view, 1);
    const graph::Extent image = imageExtent(view);
    FinerPlaces places = isFine(settings)
                             ? FinerPlaces(reinterpret_cast<const float*>(pixels), image)
                             : FinerPlaces(reinterpret_cast<const std::uint32_t*>(pixels), rowPixels, image);
    if (thin) places.grow();  // some pixels have a thin line beside their centres
    return places;
}

/// Draws finer places from the samples of one frame by tiles, for pictures by other paths. @returns whether it can
bool PictureFrames::addEdges(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                             const FinerPlaces& places) {
    if (drawsEdges(settings) || frames_.isFineMesh(settings.view) || !frames_.drawsEdges(true) ||
        settings.effects.rims())
        return false;
    const PictureRect whole = wholeOf(imageExtent(view));
    const PictureRect rect = hasLens(settings) ? places.boundsIn(whole) : whole;  // else they are all over it
    const auto [part, inner] = withRim(view, rect, rimOf(settings));
    Ending ending = inImage(settings, view, Samples::one);
    ending.picture.first = false;
    ending.picture.masked = true;
    ending.place = {rect, static_cast<std::int32_t>(inner.x), static_cast<std::int32_t>(inner.y), places.bandsIn(rect)};
    const auto [wanted, tiles] = places.edgesOf({rect.x - inner.x, rect.y - inner.y, part.width, part.height}, rect);
    return draw(settings, atlas, part, pictureTargets(settings), ending, "finer screen", Samples::edges, &tiles,
                &wanted)
        .edges;
}

/// Draws all blocks of a picture with kBlockSamples x kBlockSamples samples, where it needs them.
/// @param drew  called behind each
template <typename Drew>
void PictureFrames::drawBlocks(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted,
                               const FinerPlaces* places, const Drew& drew) {
    constexpr std::uint32_t n = RenderSettings::kBlockSamples;
    const PictureRect& all = wanted.inner;
    Ending ending = inImage(settings, wanted.view, Samples::block);
    ending.picture = {ending.picture.image, places == nullptr, places != nullptr, n};
    const std::uint32_t most = wanted.view.quarterTurns == 0 ? kBlockPixels : std::max(all.width, all.height);
    for (std::uint32_t top = 0; top < all.height; top += most)
        for (std::uint32_t left = 0; left < all.width; left += most) {
            PictureRect rect{all.x + left, all.y + top, std::min(most, all.width - left),
                             std::min(most, all.height - top)};
            if (places) rect = places->boundsIn(rect);
            if (rect.width == 0) continue;
            Wanted block{wanted.view, rect};
            if (rect.width < all.width || rect.height < all.height)
                std::tie(block.view, block.inner) = withRim(wanted.view, rect, rimOf(settings));
            TileMask mask;
            if (places)
                mask = places->tilesOf(
                    {rect.x - block.inner.x, rect.y - block.inner.y, block.view.width, block.view.height}, rect);
            const View view = scaled(block.view, n);
            checkSize(view);
            ending.place = {rect, static_cast<std::int32_t>(block.inner.x), static_cast<std::int32_t>(block.inner.y)};
            draw(settings, atlas, view, pictureTargets(settings), ending, "screen", Samples::block,
                 places ? &mask : nullptr);
            ending.picture.first = false;
            drew();
        }
}

/// As many samples on a grid where a picture with one sample per pixel shows that colours change, in blocks, so that
/// memory does not grow with the picture. A frame for each sample would list the scene as often; and lists that were
/// too long are not, of a quarter of the pixels' side.
void PictureFrames::finerPicture(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted) {
    checkSize(wanted.view);
    PictureStats sum;
    sum.frames = 0;
    const auto drew = [&] {
        ++sum.frames;
        sum.frameMilliseconds += stats_.frameMilliseconds;
        addUp(sum.passes, stats_.passes, &PassCount::shadedFragments);
        addUp(sum.passTimes, stats_.passTimes, &PassTime::milliseconds);
    };
    std::optional<FinerPlaces> places = coarsePicture(settings, atlas, wanted.view);
    if (places) {
        drew();
        // Its images' memory serves those of the lens.
        if (hasLens(settings)) executor_.forget("coarse screen");
        if (hasLens(settings) && leaveBlurred(settings, wanted.view, *places)) drew();
        picture_.finer = passes::makeTexture(device_, executor_, {VK_FORMAT_R8_UNORM, picture_.image.desc.extent},
                                             places->bytes(), "finer pixels");
    }
    if (places && places->any() && addEdges(settings, atlas, wanted.view, *places))
        drew();
    else
        drawBlocks(settings, atlas, wanted, places ? &*places : nullptr, drew);
    stats_.frames = sum.frames;
    stats_.samples = RenderSettings::kEdgeSamples;
    stats_.frameMilliseconds = sum.frameMilliseconds;
    stats_.passes = sum.passes;
    stats_.passTimes = sum.passTimes;
}

}  // namespace nacre
