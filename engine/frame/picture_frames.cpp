#include "engine/frame/picture_frames.h"

#include <algorithm>
#include <utility>

#include "engine/error.h"
#include "engine/frame/geometry.h"
#include "engine/frame/lens.h"
#include "engine/frame/picture.h"
#include "engine/graph/visibility.h"
#include "engine/milliseconds.h"
#include "engine/passes/read_back.h"

namespace nacre {
namespace {

std::string pixelsOf(const ScreenTarget& target) { return std::string(target.image) + " pixels"; }

std::uint64_t pixelBytes(const ScreenTarget& target, graph::Extent extent) {
    return std::uint64_t{extent.width} * extent.height * graph::bytesPerTexel(target.format);
}

/// A target as the host reads it: behind a lens there is the picture.
ScreenTarget readTarget(const FrameShape& shape, std::size_t i) {
    ScreenTarget target = shape.options.targets[i];
    if (shape.end == FrameEnd::throughLens) target.format = shape.picture.image.format;
    return target;
}

/// Declares the use of the targets, or of colours from compute shading.
void declareEnd(ScreenFrame& frame, const FrameShape& shape, const PictureImage& picture) {
    if (shape.end == FrameEnd::throughLens)
        declareLens(frame, shape.options.extent, shape.picture.image.format, &picture);
    const bool resolved = shape.end == FrameEnd::resolved;
    if (resolved || shape.end == FrameEnd::coarse) declareResolve(frame, shape, picture);
    if (shape.options.shadedByTiles) return frame.graph.output(frame.numbers);
    if (resolved) return;
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        if (shape.end == FrameEnd::left) {
            frame.graph.output(frame.targets[i]);
            continue;
        }
        const ScreenTarget target = readTarget(shape, i);
        const graph::Extent extent = shape.options.extent;
        frame.pixels.push_back(frame.graph.importBuffer(pixelsOf(target), pixelBytes(target, extent)));
        passes::readBack(frame.graph, frame.targets[i], {target.format, extent}, frame.pixels.back());
    }
}

/// Where the host reads the frame's targets.
std::vector<gpu::Buffer> bindPixels(const gpu::Device& device, DeclaredFrame& declared) {
    std::vector<gpu::Buffer> pixels;
    for (std::size_t i = 0; i < declared.frame.pixels.size(); ++i) {
        const ScreenTarget target = readTarget(declared.shape, i);
        pixels.push_back(gpu::makeBuffer(device, pixelBytes(target, declared.shape.options.extent),
                                         vk::BufferUsageFlagBits::eTransferDst, gpu::Access::readback,
                                         pixelsOf(target)));
        declared.imports.bind(declared.frame.pixels[i], pixels.back());
    }
    return pixels;
}

}  // namespace

/// Debug views show single samples.
bool PictureFrames::wantsEdges(const RenderSettings& settings) {
    return settings.supersample == RenderSettings::kEdges && settings.debug == DebugView::none;
}

/// Debug views are no finer than the eye.
bool PictureFrames::isFine(const RenderSettings& settings) {
    return settings.fine && settings.debug == DebugView::none;
}

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
    return declared_.of(seen.shape, [&](ScreenFrame& frame) { declareEnd(frame, seen.shape, picture_); });
}

PictureFrames::Drawn PictureFrames::draw(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                                         std::span<const ScreenTarget> targets, const Ending& ending, const char* name,
                                         Samples samples, const TileMask* mask, const passes::EdgePlaces* places) {
    std::shared_ptr<passes::FragmentCounter> fragments;
    if (settings.tuning.countFragments) fragments = std::make_shared<passes::FragmentCounter>(device_);
    const bool edges = samples == Samples::edges;
    SeenFrame seen = frames_.see({settings,
                                  atlas,
                                  view,
                                  targets,
                                  name,
                                  ending.end,
                                  fragments,
                                  edges,
                                  {},
                                  samples == Samples::block,
                                  samples == Samples::resolved ? graph::kMultisamples : 1,
                                  mask,
                                  edges || samples == Samples::block || ending.finer,
                                  places});
    seen.shape.picture = ending.picture;
    seen.shape.options.intoPicture = (ending.end == FrameEnd::resolved || ending.end == FrameEnd::coarse) &&
                                     ending.picture.first && ending.picture.samples == 1 &&
                                     !seen.shape.options.shadedByTiles;
    Drawn drawn;
    drawn.edges = seen.shape.options.edges;
    if (edges && !drawn.edges) return drawn;
    picture_.place = ending.place;
    picture_.tiles = seen.view->tiles.get();
    const std::shared_ptr<DeclaredFrame> declared = declare(seen);
    SceneFrames::bind(*declared, seen);
    if (declared->frame.picture) declared->imports.bind(*declared->frame.picture, picture_.image);
    if (declared->frame.finer) declared->imports.bind(*declared->frame.finer, picture_.finer);
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

const std::string& PictureFrames::planText() {
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
    const std::uint64_t pixels = putOver(picture, settings.background);
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

CodedPicture PictureFrames::coded(RenderSettings settings, const passes::Atlas& atlas, bool alpha) {
    settings.fine = false;
    const Wanted wanted = wantedOf(settings);
    if (averagesOnHost(settings)) return nacre::coded(inSeveral(settings, atlas, wanted), alpha);
    const Drawn drawn = inOnePixelEach(settings, atlas, wanted);
    const auto [pixels, rowPixels] = rowsOf(drawn, wanted.view, 1);
    return codePixels(reinterpret_cast<const std::uint32_t*>(pixels), {rowPixels, 1, wanted.inner}, settings.background,
                      alpha, stats_.coveredPixels);
}

Picture PictureFrames::picture(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted) {
    if (averagesOnHost(settings)) return inSeveral(settings, atlas, wanted);
    return resolved(inOnePixelEach(settings, atlas, wanted), settings, wanted, 1);
}

/// Whether the picture is one of N x N samples per pixel, and no more.
bool PictureFrames::averagesOnHost(const RenderSettings& settings) {
    return !hasLens(settings) && !wantsEdges(settings) && settings.supersample > 1;
}

/// In the frame itself. A small picture of a fine mesh is not: there the host finds the triangle of each sample, as it
/// does with one sample per pixel, where a frame with edges searches long lists.
bool PictureFrames::drawsEdges(const RenderSettings& settings) const {
    return frames_.drawsEdges() && !settings.effects.rims() && !frames_.isFineMesh(settings.view);
}

/// Draws a picture with a pixel for each of its own.
PictureFrames::Drawn PictureFrames::inOnePixelEach(const RenderSettings& settings, const passes::Atlas& atlas,
                                                   const Wanted& wanted) {
    if (hasLens(settings)) return throughLens(settings, atlas, wanted);
    const bool edges = wantsEdges(settings);
    if (!edges || drawsEdges(settings)) {
        Drawn drawn = inOneFrame(settings, atlas, wanted, {FrameEnd::readBack});
        if (!edges || drawn.edges) return drawn;  // else a list was too long
    }
    finerPicture(settings, atlas, wanted);
    return readPicture();
}

/// Draws the picture in one frame, if its shape has the edges that it takes.
PictureFrames::Drawn PictureFrames::inOneFrame(const RenderSettings& settings, const passes::Atlas& atlas,
                                               const Wanted& wanted, const Ending& ending) {
    const bool edges = wantsEdges(settings);
    const std::uint32_t n = ending.picture.samples;
    const View view = scaled(wanted.view, n);
    checkSize(view);
    const Samples samples = edges ? Samples::edges : singleOrResolved(settings);
    stats_.frames = 1;
    stats_.samples = edges ? RenderSettings::kEdgeSamples : samples == Samples::resolved ? graph::kMultisamples : n * n;
    return draw(settings, atlas, view, pictureTargets(settings, samples), ending, "screen", samples);
}

/// Draws a picture with N x N pixels for each of its own.
Picture PictureFrames::inSeveral(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted) {
    const std::uint32_t n = settings.supersample;
    const View view = scaled(wanted.view, n);
    checkSize(view);
    stats_.frames = 1;
    stats_.samples = n * n;
    const Drawn drawn = draw(settings, atlas, view, pictureTargets(settings), {FrameEnd::readBack}, "screen");
    return resolved(drawn, settings, wanted, n);
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
        return draw(settings, atlas, view, pictureTargets(settings, samples), {}, "screen", samples).edges;
    };
    const graph::Extent image = imageExtent(view);
    if (edges && !(inFrame && drawn()))
        finerPicture(settings, atlas, {view, {0, 0, image.width, image.height}});
    else if (!edges)
        drawn();
}

}  // namespace nacre
