#include "engine/frame/picture_frames.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "engine/error.h"
#include "engine/frame/geometry.h"
#include "engine/frame/lens.h"
#include "engine/frame/picture.h"
#include "engine/graph/visibility.h"
#include "engine/milliseconds.h"
#include "engine/passes/read_back.h"
#include "engine/scene/tile_lists.h"

namespace nacre {
namespace {

constexpr std::uint32_t kBlockPixels = 384;  ///< a side: 2 million samples and those of their rim
static_assert(kBlockPixels % PictureRect::kStep == 0);

std::string pixelsOf(const ScreenTarget& target) { return std::string(target.image) + " pixels"; }

std::uint64_t pixelBytes(const ScreenTarget& target, graph::Extent extent) {
    return std::uint64_t{extent.width} * extent.height * graph::bytesPerTexel(target.format);
}

/// Declares the use of the targets, or of colours from compute shading.
void declareEnd(ScreenFrame& frame, const FrameShape& shape, const passes::Lens& lens) {
    if (shape.end == FrameEnd::throughLens) declareLens(frame, shape.options.extent, &lens);
    if (shape.options.shadedByTiles) return frame.graph.output(frame.numbers);
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        if (shape.end == FrameEnd::left) {
            frame.graph.output(frame.targets[i]);
            continue;
        }
        const ScreenTarget& target = shape.options.targets[i];
        const graph::Extent extent = shape.options.extent;
        frame.pixels.push_back(frame.graph.importBuffer(pixelsOf(target), pixelBytes(target, extent)));
        passes::readBack(frame.graph, frame.targets[i], {target.format, extent}, frame.pixels.back());
    }
}

/// Where the host reads the frame's targets.
std::vector<gpu::Buffer> bindPixels(const gpu::Device& device, DeclaredFrame& declared) {
    std::vector<gpu::Buffer> pixels;
    for (std::size_t i = 0; i < declared.frame.pixels.size(); ++i) {
        const ScreenTarget& target = declared.targets[i];
        pixels.push_back(gpu::makeBuffer(device, pixelBytes(target, declared.shape.options.extent),
                                         vk::BufferUsageFlagBits::eTransferDst, gpu::Access::readback,
                                         pixelsOf(target)));
        declared.imports.bind(declared.frame.pixels[i], pixels.back());
    }
    return pixels;
}

/// Debug views show single samples.
bool wantsEdges(const RenderSettings& settings) {
    return settings.supersample == RenderSettings::kEdges && settings.debug == DebugView::none;
}

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

/// Debug views are no finer than the eye.
bool isFine(const RenderSettings& settings) { return settings.fine && settings.debug == DebugView::none; }

/// Margin around a part, in pixels, that influences it: neighbours for edges, and the reach of outlines and halos.
std::uint32_t rimOf(const RenderSettings& settings) {
    constexpr std::uint32_t kRim = PictureRect::kStep;
    static_assert(kRim == TileLists::kBinPixels);  // its bins are those of the whole
    double reach = std::max(settings.effects.contours.width, settings.effects.halos.width);
    if (hasLens(settings)) reach += largestCircle(settings) + passes::kLensBlock;
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

}  // namespace

/// Samples of a picture that is drawn without supersampling. @throws Error if the device's options ask for more than
/// these settings can have
PictureFrames::Samples PictureFrames::singleOrResolved(const RenderSettings& settings) const {
    if (!device_.caps().samplesPictures || settings.supersample != 1) return Samples::one;
    if (const std::string lacks = frames_.lacksSamples(settings); !lacks.empty())
        throw Error("cannot draw 4 samples per pixel", "--msaa 4", lacks);
    return Samples::resolved;
}

std::span<const ScreenTarget> PictureFrames::pictureTargets(const RenderSettings& settings, Samples samples) const {
    if (isFine(settings)) return kFineTargets;
    // The device averages linear colours: no shader codes them.
    return samples != Samples::resolved && device_.caps().tiles.shade && !frames_.translucent() ? kCodedTargets
                                                                                                : kScreenTargets;
}

const std::shared_ptr<DeclaredFrame>& PictureFrames::declare(const SeenFrame& seen) {
    return declared_.of(seen.shape, [&](ScreenFrame& frame) { declareEnd(frame, seen.shape, lens_); });
}

PictureFrames::Drawn PictureFrames::draw(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                                         std::span<const ScreenTarget> targets, bool readBack, const char* name,
                                         Samples samples, const TileMask* mask, const gpu::Buffer* sharp) {
    std::shared_ptr<passes::FragmentCounter> fragments;
    if (settings.tuning.countFragments) fragments = std::make_shared<passes::FragmentCounter>(device_);
    const FrameEnd end = sharp ? FrameEnd::throughLens : readBack ? FrameEnd::readBack : FrameEnd::left;
    const bool edges = samples == Samples::edges;
    SeenFrame seen = frames_.see({settings,
                                  atlas,
                                  view,
                                  targets,
                                  name,
                                  end,
                                  fragments,
                                  edges,
                                  {},
                                  samples == Samples::block,
                                  samples == Samples::resolved ? graph::kMultisamples : 1,
                                  mask,
                                  samples == Samples::edges || samples == Samples::block || sharp});
    const std::shared_ptr<DeclaredFrame> declared = declare(seen);
    SceneFrames::bind(*declared, seen);
    if (sharp) declared->imports.bind(*declared->frame.sharp, *sharp);
    Drawn drawn;
    drawn.edges = seen.shape.options.edges;
    if (edges && !drawn.edges) return drawn;
    drawn.smallestPixels = seen.view->smallestPixels;
    drawn.colors = seen.colors();
    drawn.pixels = bindPixels(device_, *declared);
    const auto start = Clock::now();
    const auto record = [&](gpu::CommandBuffer& c) {
        executor_.record(c, *declared->recording, declared->imports, settings.tuning.timePasses ? &timer_ : nullptr);
        if (fragments) fragments->finish(*c);
    };
    device_.submitAndWait(record, gpu::Device::Ends::frame);
    stats_.frameMilliseconds = millisecondsSince(start);
    executor_.reset();
    for (const gpu::Buffer& pixels : drawn.pixels) pixels.invalidate();
    if (drawn.colors) drawn.colors->numbers.buffer.invalidate();
    if (fragments) stats_.passes = fragments->counts();
    if (settings.tuning.timePasses) stats_.passTimes = timer_.times();
    if (last_ != declared) planText_.clear();
    last_ = declared;
    tell(seen, settings.tuning);
    counts_ = std::move(seen.counts);
    return drawn;
}

/// Records the last frame.
void PictureFrames::tell(const SeenFrame& seen, const FrameTuning& tuning) {
    const graph::Plan& plan = last_->plan;
    stats_.tileBytesPerPixel = graph::tileBytesPerPixel(plan);
    stats_.loadedBytes = plan.total.loaded;
    stats_.storedBytes = plan.total.stored;
    stats_.deviceBytes = device_.peakAllocatedBytes();
    stats_.deviceBytesHeld = device_.allocatedBytes();
    const graph::GeometryCaps& caps = device_.caps().plan.geometry;
    tellGeometry(last_->frame.graph, seen.counts, caps, tuning.plates, tuning.impostor, stats_.geometry);
    stats_.storesVaryings = caps.storesVaryings;
}

const std::string& PictureFrames::planText() const {
    if (planText_.empty() && last_) planText_ = graph::describe(last_->frame.graph, last_->plan);
    return planText_;
}

/// @throws Error if the view exceeds the device's limits
void PictureFrames::checkSize(const View& view) const {
    const std::uint32_t most = device_.caps().maxImageSize;
    if (std::max(view.width, view.height) > most)
        throw Error("picture too large", std::to_string(view.width) + "x" + std::to_string(view.height),
                    "this device draws at most " + std::to_string(most) + " pixels per side, supersampling included");
}

/// Where the host reads a frame's pixels, and how many of them a row has.
/// @param view  at the device's resolution divided by n
std::pair<const std::byte*, std::uint32_t> PictureFrames::rowsOf(const Drawn& drawn, const View& view,
                                                                 std::uint32_t n) {
    if (drawn.colors) return {drawn.colors->numbers.buffer.mapped, drawn.colors->rowPixels()};
    return {drawn.pixels[0].mapped, imageExtent(view).width * n};
}

/// @returns the number of covered samples
std::uint64_t PictureFrames::resolve(const Drawn& drawn, const RenderSettings& settings, const View& view,
                                     ResolvedPart part, Picture& to) {
    const auto [pixels, rowPixels] = rowsOf(drawn, view, part.n);
    part.rowPixels = rowPixels;
    if (isFine(settings)) return resolvePixels(reinterpret_cast<const float*>(pixels), part, to);
    return resolvePixels(reinterpret_cast<const std::uint32_t*>(pixels), part, to);
}

Picture PictureFrames::resolved(const Drawn& drawn, const RenderSettings& settings, const Wanted& wanted,
                                std::uint32_t n) {
    Picture picture = emptyPicture(wanted.inner.width, wanted.inner.height);
    const std::uint64_t samples = resolve(drawn, settings, wanted.view, {0, n, wanted.inner}, picture);
    const std::uint64_t pixels = putOver(picture, behind(settings));
    stats_.coveredPixels = wantsEdges(settings) ? pixels : samples;
    return picture;
}

/// All of a view.
PictureFrames::Wanted PictureFrames::wantedOf(const RenderSettings& settings) {
    const graph::Extent image = imageExtent(settings.view);
    return {settings.view, {0, 0, image.width, image.height}};
}

Picture PictureFrames::picture(const RenderSettings& settings, const passes::Atlas& atlas) {
    return picture(settings, atlas, wantedOf(settings));
}

Picture PictureFrames::part(const RenderSettings& settings, const passes::Atlas& atlas, const PictureRect& part) {
    const auto [view, inner] = withRim(settings.view, part, rimOf(settings));
    return picture(settings, atlas, {view, inner});
}

CodedPicture PictureFrames::coded(RenderSettings settings, const passes::Atlas& atlas, bool alpha) {
    settings.fine = false;
    const Wanted wanted = wantedOf(settings);
    if (hasLens(settings)) return nacre::coded(throughLens(settings, atlas, wanted), alpha);
    const std::optional<Drawn> drawn = inOnePixelEach(settings, atlas, wanted);
    if (!drawn) return nacre::coded(inSeveral(settings, atlas, wanted), alpha);
    const auto [pixels, rowPixels] = rowsOf(*drawn, wanted.view, 1);
    return codePixels(reinterpret_cast<const std::uint32_t*>(pixels), {rowPixels, 1, wanted.inner}, settings.background,
                      alpha, stats_.coveredPixels);
}

Picture PictureFrames::picture(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted) {
    return hasLens(settings) ? throughLens(settings, atlas, wanted) : sharp(settings, atlas, wanted);
}

/// Without the lens. If there is one, the background is left out, too.
Picture PictureFrames::sharp(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted) {
    const std::optional<Drawn> drawn = inOnePixelEach(settings, atlas, wanted);
    return drawn ? resolved(*drawn, settings, wanted, 1) : inSeveral(settings, atlas, wanted);
}

bool PictureFrames::drawsEdges(const RenderSettings& settings) const {
    return frames_.drawsEdges() && !settings.effects.rims();
}

/// Draws a picture in a frame with a pixel for each of its own. @returns nothing if it takes more
std::optional<PictureFrames::Drawn> PictureFrames::inOnePixelEach(const RenderSettings& settings,
                                                                  const passes::Atlas& atlas, const Wanted& wanted) {
    const bool edges = wantsEdges(settings);
    if (edges ? !drawsEdges(settings) : settings.supersample > 1) return {};
    checkSize(wanted.view);
    const Samples samples = edges ? Samples::edges : singleOrResolved(settings);
    stats_.frames = 1;
    stats_.samples = edges ? RenderSettings::kEdgeSamples : samples == Samples::resolved ? graph::kMultisamples : 1;
    Drawn drawn = draw(settings, atlas, wanted.view, pictureTargets(settings, samples), true, "screen", samples);
    if (edges && !drawn.edges) return {};  // a list was too long
    return drawn;
}

/// Draws a picture with N x N pixels for each of its own.
Picture PictureFrames::inSeveral(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted) {
    stats_.frames = 1;
    if (wantsEdges(settings)) {
        stats_.samples = RenderSettings::kEdgeSamples;
        checkSize(wanted.view);
        return blocksOfSamples(settings, atlas, wanted, true);
    }
    const std::uint32_t n = settings.supersample;
    const View view = scaled(wanted.view, n);
    checkSize(view);
    stats_.samples = n * n;
    return resolved(draw(settings, atlas, view, pictureTargets(settings), true, "screen"), settings, wanted, n);
}

/// Draws a picture with one sample per pixel. @param to  receives it, without its background
/// @returns where it needs more samples; nothing: in all pixels, as something may lie between their centres
std::optional<FinerPlaces> PictureFrames::coarsePicture(const RenderSettings& settings, const passes::Atlas& atlas,
                                                        const View& view, Picture& to) {
    constexpr double kSmallPixels = 0.75;  // half of a width
    constexpr double kThinLine = 0.34;     // of the widest, as shaders/common/rims.glsl has it
    const Contours& lines = settings.effects.contours;
    if (view.quarterTurns != 0) return {};
    if (settings.effects.linesByGroups() && kThinLine * lines.width < 1) return {};
    const Drawn drawn = draw(settings, atlas, view, pictureTargets(settings), true, "coarse screen");
    if (drawn.smallestPixels < kSmallPixels) return {};
    resolve(drawn, settings, view, {0, 1, {0, 0, to.width, to.height}}, to);
    return FinerPlaces(to);
}

/// Draws finer places from the samples of one frame by tiles, for pictures by other paths. @returns whether it can
bool PictureFrames::addEdges(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                             const FinerPlaces& places, Picture& to) {
    if (drawsEdges(settings) || !frames_.drawsEdges(true) || settings.effects.rims()) return false;
    const Drawn drawn = draw(settings, atlas, view, pictureTargets(settings), true, "finer screen", Samples::edges);
    if (!drawn.edges) return false;
    resolve(drawn, settings, view, {0, 1, {0, 0, to.width, to.height}, 0, 0, &places}, to);
    return true;
}

/// As many samples on a grid where a picture with one sample per pixel shows that colours change, in blocks, so that
/// memory does not grow with the picture. A frame for each sample would list the scene as often; and lists that were
/// too long are not, of a quarter of the pixels' side.
Picture PictureFrames::blocksOfSamples(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted,
                                       bool readBack) {
    constexpr std::uint32_t n = RenderSettings::kBlockSamples;
    const PictureRect& all = wanted.inner;
    const graph::Extent image = imageExtent(wanted.view);
    Picture whole = emptyPicture(image.width, image.height);
    PictureStats sum;
    sum.frames = 0;
    const auto drew = [&] {
        ++sum.frames;
        sum.frameMilliseconds += stats_.frameMilliseconds;
        addUp(sum.passes, stats_.passes, &PassCount::shadedFragments);
        addUp(sum.passTimes, stats_.passTimes, &PassTime::milliseconds);
    };
    const std::optional<FinerPlaces> places = coarsePicture(settings, atlas, wanted.view, whole);
    if (places) drew();
    const bool inOneFrame = places && addEdges(settings, atlas, wanted.view, *places, whole);
    if (inOneFrame) drew();
    const std::uint32_t most = wanted.view.quarterTurns == 0 ? kBlockPixels : std::max(all.width, all.height);
    for (std::uint32_t top = 0; top < all.height && !inOneFrame; top += most)
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
            const Drawn drawn = draw(settings, atlas, view, pictureTargets(settings), readBack, "screen",
                                     Samples::block, places ? &mask : nullptr);
            drew();
            if (readBack)
                resolve(drawn, settings, block.view, {0, n, block.inner, rect.x, rect.y, places ? &*places : nullptr},
                        whole);
        }
    stats_.frames = sum.frames;
    stats_.frameMilliseconds = sum.frameMilliseconds;
    stats_.passes = sum.passes;
    stats_.passTimes = sum.passTimes;
    if (!readBack) return {};
    whole = cut(std::move(whole), all);
    stats_.coveredPixels = putOver(whole, behind(settings));
    return whole;
}

void PictureFrames::frame(const RenderSettings& settings, const passes::Atlas& atlas) {
    if (hasLens(settings)) return void(throughLens(settings, atlas, wantedOf(settings)));
    const bool edges = wantsEdges(settings);
    const std::uint32_t n = edges ? 1 : std::max(settings.supersample, 1u);
    const View view = scaled(settings.view, n);
    checkSize(view);
    stats_.frames = 1;
    const Samples single = singleOrResolved(settings);
    stats_.samples = edges ? RenderSettings::kEdgeSamples : single == Samples::resolved ? graph::kMultisamples : n * n;
    const bool inFrame = edges && drawsEdges(settings);
    const auto drawn = [&] {
        const Samples samples = inFrame ? Samples::edges : single;
        return draw(settings, atlas, view, pictureTargets(settings, samples), false, "screen", samples).edges;
    };
    const graph::Extent image = imageExtent(view);
    if (edges && !(inFrame && drawn()))
        blocksOfSamples(settings, atlas, {view, {0, 0, image.width, image.height}}, false);
    else if (!edges)
        drawn();
}

}  // namespace nacre
