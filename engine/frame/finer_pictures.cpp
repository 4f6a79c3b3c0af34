// Pictures with more samples where they need them, in one frame or in blocks, and parts of pictures.

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "engine/frame/effects/lens/lens.h"
#include "engine/frame/picture_frames.h"
#include "engine/passes/read_back.h"

namespace nacre {
namespace {

/// Samples of a block, without those of the rim. Where few are wanted, buffers of a small block stay in the caches.
constexpr std::uint32_t kBlockSide = 1536, kSideOfPlaces = 768;
static_assert(kSideOfPlaces / FinerPlaces::kMany % PictureRect::kStep == 0 && kBlockSide % kSideOfPlaces == 0);

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
std::uint32_t measureRim(const RenderSettings& settings, double more = 0) {
    constexpr std::uint32_t kRim = PictureRect::kStep;
    static_assert(kRim == TileBins::kPixels);  // bins of a part are bins of the whole
    const double reach = std::max(settings.effects.contours.width, settings.effects.halos.width) + more;
    return kRim * std::max(static_cast<std::uint32_t>(std::ceil(reach / kRim)), 1u);
}

/// A rectangle of a view with a margin, clamped to the view, and the rectangle's position in it.
std::pair<View, PictureRect> withRim(const View& whole, const PictureRect& part, std::uint32_t rim) {
    const std::uint32_t left = part.x - std::min(part.x, rim), top = part.y - std::min(part.y, rim);
    const std::uint32_t right = std::min(part.x + part.width + rim, whole.width);
    const std::uint32_t bottom = std::min(part.y + part.height + rim, whole.height);
    return {cropView(whole, left, top, right - left, bottom - top),
            {part.x - left, part.y - top, part.width, part.height}};
}

/// Whether a sample depends on its neighbours: on lines and halos, whose widths assume kBlockSamples samples per side.
bool looksAround(const RenderSettings& settings) {
    return settings.effects.contours.width > 0 || settings.effects.halos.width > 0;
}

/// As measureRim(), of blocks.
std::uint32_t rimOfBlocks(const RenderSettings& settings) { return looksAround(settings) ? measureRim(settings) : 0; }

/// The parts of a block that show anything, each in a band of rows. One empty part: none does.
/// @param spans  of the block's frame @param rect  of the picture @param inner  the same in the frame
std::vector<PictureRect> findShown(std::span<const TileBins::Span> spans, const PictureRect& rect,
                                   const PictureRect& inner) {
    constexpr std::uint32_t kBin = TileBins::kPixels / RenderSettings::kBlockSamples, kRows = 2 * PictureRect::kStep;
    static_assert(kRows % kBin == 0 && PictureRect::kStep % kBin == 0);  // no bin is in two bands
    std::vector<std::pair<std::uint32_t, std::uint32_t>> reach((rect.height + kRows - 1) / kRows, {rect.width, 0});
    for (const TileBins::Span& s : spans) {
        const std::uint32_t left = std::max(s.x * kBin, inner.x), right = std::min(s.endX * kBin, inner.x + rect.width);
        for (std::uint32_t y = std::max(s.y * kBin, inner.y); y < std::min(s.endY * kBin, inner.y + rect.height);
             y += kBin) {
            if (right <= left) break;
            auto& [from, to] = reach[(y - inner.y) / kRows];
            from = std::min(from, left - inner.x);
            to = std::max(to, right - inner.x);
        }
    }
    std::vector<PictureRect> parts;
    for (std::uint32_t band = 0; band < reach.size(); ++band) {
        const auto [from, to] = reach[band];
        const std::uint32_t y = band * kRows;
        if (from < to) parts.push_back({rect.x + from, rect.y + y, to - from, std::min(kRows, rect.height - y)});
    }
    if (parts.empty()) parts.push_back({rect.x, rect.y, 0, 0});
    return parts;
}

/// Adds the bins of a frame that may show shapes between pixel centres; without lists of tiles, all.
void addSmall(FinerPlaces& places, const passes::SceneView& view, graph::Extent image) {
    constexpr std::uint32_t kBin = TileBins::kPixels;
    if (!view.tiles) return places.add({0, 0, image.width, image.height});
    for (std::uint32_t y = 0; y * kBin < image.height; ++y)
        for (std::uint32_t x = 0; x * kBin < image.width; ++x)
            if (view.tiles->showsSmall(x, y)) places.add({x * kBin, y * kBin, kBin, kBin});
    if (view.translucent) addSmall(places, *view.translucent, image);
}

PictureRect wholeRect(graph::Extent image) { return {0, 0, image.width, image.height}; }

/// Places where colours over an opaque background differ. @param pixels  as for codePixels()
FinerPlaces findFiner(const std::uint32_t* pixels, const ResolvedPart& part, const std::array<float, 4>& background) {
    std::uint64_t covered = 0;
    const CodedPicture seen = codePixels(pixels, part, background, true, covered);
    return {reinterpret_cast<const std::uint32_t*>(seen.bytes.data()),
            part.rect.width,
            {part.rect.width, part.rect.height}};
}

}  // namespace

Picture PictureFrames::part(const RenderSettings& settings, const passes::Atlas& atlas, const PictureRect& part) {
    const double reach = hasLens(settings) ? largestCircle(settings) + passes::kLensBlock : 0;
    const auto [view, inner] = withRim(settings.view, part, measureRim(settings, reach));
    return picture(settings, atlas, {view, inner});
}

/// Makes a frame end in the picture's image, and fill it. @param picture  its view
/// @param n  n x n pixels of the frame form one of the picture
void PictureFrames::endInPicture(PreparedFrame& prepared, const View& picture, std::uint32_t n) {
    using Usage = vk::ImageUsageFlagBits;
    const graph::ImageDesc desc{prepared.shape.targets[0].format, imageExtent(picture)};
    if (picture_.image.desc != desc) {
        executor_.forgetFramebuffers();
        picture_.image = gpu::makeImage(
            device_, desc, Usage::eColorAttachment | Usage::eSampled | Usage::eTransferSrc | Usage::eTransferDst, false,
            "picture");
    }
    prepared.shape.picture = {desc, true, false, n};
    picture_.place = {wholeRect(desc.extent)};
}

/// Declares the reading of the picture's image.
PictureFrames::Reading PictureFrames::declareReading() const {
    const graph::ImageDesc& desc = picture_.image.desc;
    const std::uint64_t bytes =
        std::uint64_t{desc.extent.width} * desc.extent.height * graph::bytesPerTexel(desc.format);
    Reading reading;
    reading.drawn.pixels.push_back(gpu::makeBuffer(device_, bytes, vk::BufferUsageFlagBits::eTransferDst,
                                                   gpu::Access::readback, "picture pixels"));
    const graph::Image image = reading.graph.importImage("picture", desc, passes::kTextureState);
    const graph::Buffer buffer = reading.graph.importBuffer("picture pixels", bytes);
    passes::readBack(reading.graph, image, desc, buffer);
    reading.imports.bind(image, picture_.image);
    reading.imports.bind(buffer, reading.drawn.pixels[0]);
    return reading;
}

/// The picture's image in memory that the host reads.
PictureFrames::Drawn PictureFrames::readPicture() {
    if (!read_) {
        Reading reading = declareReading();
        executor_.run(reading.graph, reading.imports);
        read_ = std::move(reading.drawn);
    }
    Drawn drawn = *std::exchange(read_, std::nullopt);
    drawn.pixels[0].invalidate();
    return drawn;
}

/// Draws a picture with one sample per pixel. @returns the pixels that need more
FinerPlaces PictureFrames::drawCoarse(const RenderSettings& settings, const Wanted& wanted, PreparedFrame coarse) {
    constexpr double kThinOutline = 0.34;  // share of the widest width; same as in shaders/common/rims.glsl
    coarse.shape.name = "coarse screen";
    endInPicture(coarse, wanted.view, 1);
    const bool fine = coarse.choice().color == ColorFormat::linear, blends = coarse.facts.blends();
    const std::shared_ptr<const passes::SceneView> seen = coarse.view;
    const Drawn drawn = run(std::move(coarse), settings);
    const auto [pixels, rowPixels] = pictureRows(drawn, wanted.view, 1);
    const graph::Extent image = imageExtent(wanted.view);
    const auto* codes = reinterpret_cast<const std::uint32_t*>(pixels);
    const std::array<float, 4>& under = settings.background;
    const bool over = blends && under[3] == 1;
    FinerPlaces places = fine   ? FinerPlaces(reinterpret_cast<const float*>(pixels), image,
                                            over ? linearColor({under[0], under[1], under[2]}, 1) : glm::vec4(0))
                           : over ? findFiner(codes, {rowPixels, 1, wholeRect(image)}, under)
                                : FinerPlaces(codes, rowPixels, image);
    // At some pixels a thin outline misses the centre.
    if (settings.effects.linesByGroups() && kThinOutline * settings.effects.contours.width < 1) places.grow();
    if (seen->smallestPixels < passes::TileWork::kSmallPixels) addSmall(places, *seen, image);
    // An edge between like colours of opaque shapes may be beside one between unlike ones, in the same pixel.
    if (!blends || looksAround(settings)) places.takeMany();
    return places;
}

/// Draws the samples of finer places in one frame by tiles, for pictures by other paths.
/// @returns false if the tiles' lists are too long
bool PictureFrames::drawEdges(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                              const FinerPlaces& places, Ending ending) {
    const PictureRect whole = wholeRect(imageExtent(view));
    const PictureRect rect = hasLens(settings) ? places.boundsIn(whole) : whole;  // else they are everywhere
    const auto [part, inner] = withRim(view, rect, measureRim(settings));
    const auto [wanted, tiles] = places.findEdges({rect.x - inner.x, rect.y - inner.y, part.width, part.height}, rect);
    FrameInputs inputs{atlas, part, "finer screen"};
    inputs.mask = &tiles;
    inputs.places = &wanted;
    PreparedFrame edges = prepare({settings, Part::edges}, inputs);
    if (edges.choice().givesWay()) return false;
    edges.shape.picture = {picture_.image.desc, false, true, 1};
    picture_.place = {rect, static_cast<std::int32_t>(inner.x), static_cast<std::int32_t>(inner.y),
                      places.bandsIn(rect)};
    if (ending == Ending::readBack && !hasLens(settings)) reading_ = declareReading();
    run(std::move(edges), settings);
    return true;
}

/// Draws a picture in blocks with n x n samples per pixel.
/// @param places  only those that need as many; null: everywhere
/// @param drew  called after each block
template <typename Drew>
void PictureFrames::drawBlocks(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted,
                               const FinerPlaces* places, std::uint32_t n, const Drew& drew) {
    const PictureRect& all = wanted.inner;
    bool first = places == nullptr;  // of the picture's frames
    const std::uint32_t side = (places ? kSideOfPlaces : kBlockSide) / n;
    const std::uint32_t most = wanted.view.quarterTurns == 0 ? side : std::max(all.width, all.height);
    for (std::uint32_t top = 0; top < all.height; top += most)
        for (std::uint32_t left = 0; left < all.width; left += most) {
            PictureRect rect{all.x + left, all.y + top, std::min(most, all.width - left),
                             std::min(most, all.height - top)};
            if (places) rect = places->boundsIn(rect, n);
            if (rect.width == 0) continue;
            Wanted block{wanted.view, rect};
            if (rect.width < all.width || rect.height < all.height)
                std::tie(block.view, block.inner) = withRim(wanted.view, rect, rimOfBlocks(settings));
            TileMask mask;
            if (places)
                mask = places->findTiles(
                    {rect.x - block.inner.x, rect.y - block.inner.y, block.view.width, block.view.height}, rect, n);
            const View view = scaled(block.view, n);
            checkSize(view);
            FrameInputs inputs{atlas, view};
            inputs.mask = places ? &mask : nullptr;
            PreparedFrame prepared = prepare({settings, Part::block}, inputs);
            endInPicture(prepared, wanted.view, n);
            prepared.shape.picture.first = first;
            prepared.shape.picture.masked = places != nullptr;
            picture_.place = {rect, static_cast<std::int32_t>(block.inner.x), static_cast<std::int32_t>(block.inner.y)};
            if (!places && prepared.choice().shadedByCompute())
                picture_.place.parts = findShown(prepared.view->tiles->spans(), rect, block.inner);
            run(std::move(prepared), settings);
            first = false;
            drew();
        }
}

/// Draws a picture with more samples where the coarse frame changes colour, or everywhere, as its choice says.
/// @param first  the coarse frame, or one that gives way to others
void PictureFrames::refine(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted,
                           PreparedFrame first, Ending ending) {
    upload_.reset(), reading_.reset(), read_.reset();  // a failed picture may have left some
    const Refinement refinement = first.choice().refinement;
    PictureStats sum;
    sum.frames = 0;
    const auto drew = [&] {
        ++sum.frames;
        sum.frameMilliseconds += stats_.frameMilliseconds;
        addUp(sum.passes, stats_.passes, &PassCount::shadedFragments);
        addUp(sum.passTimes, stats_.passTimes, &PassTime::milliseconds);
    };
    std::optional<FinerPlaces> places;
    if (refinement != Refinement::everywhere) {
        if (first.choice().givesWay()) first = prepare({settings, Part::coarse}, {atlas, wanted.view});
        places = drawCoarse(settings, wanted, std::move(first));
        drew();
        // The memory of its images serves the lens.
        if (hasLens(settings)) executor_.forget("coarse screen");
        if (hasLens(settings) && leaveBlurred(settings, wanted.view, *places)) drew();
        upload_ = passes::uploadTexture(device_, {VK_FORMAT_R8_UNORM, picture_.image.desc.extent}, places->bytes(),
                                        "finer pixels");
        picture_.finer = std::move(upload_->image);
    }
    if (refinement == Refinement::edges && places->any() && drawEdges(settings, atlas, wanted.view, *places, ending)) {
        drew();
    } else {
        drawBlocks(settings, atlas, wanted, places ? &*places : nullptr, FinerPlaces::kMany, drew);
        if (places) drawBlocks(settings, atlas, wanted, &*places, FinerPlaces::kFew, drew);
    }
    stats_.frames = sum.frames;
    stats_.samples = RenderSettings::kEdgeSamples;
    stats_.frameMilliseconds = sum.frameMilliseconds;
    stats_.passes = sum.passes;
    stats_.passTimes = sum.passTimes;
}

}  // namespace nacre
