#include "engine/frame/picture_frames.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/frame/effects/lens/lens.h"
#include "engine/frame/geometry.h"
#include "engine/milliseconds.h"

namespace nacre {
namespace {

std::string pixelsName(const ScreenTarget& target) { return std::string(target.image) + " pixels"; }

/// Bytes of all views.
std::uint64_t pixelBytes(const ScreenTarget& target, const FrameShape& shape) {
    return std::uint64_t{shape.extent.width} * shape.extent.height * shape.choice.views *
           graph::bytesPerTexel(target.format);
}

/// A target as the host reads it: with a lens, the blurred picture.
ScreenTarget readTarget(const FrameShape& shape, std::size_t i) {
    ScreenTarget target = shape.targets[i];
    if (shape.choice.ending == Ending::throughLens) target.format = shape.picture.image.format;
    return target;
}

/// Declares the use of the targets, or of colours from compute shading.
void declareEnding(Frame& frame, const FrameShape& shape, const PictureImage& picture) {
    const Ending ending = shape.choice.ending;
    if (ending == Ending::throughLens) declareLens(frame, shape.extent, shape.picture.image.format, &picture);
    if (ending == Ending::picture || ending == Ending::pictureAndHost) declareResolve(frame, shape, picture);
    if (shape.choice.shadedByCompute()) return frame.graph.output(frame.numbers);
    if (ending == Ending::picture) return;
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        if (ending == Ending::left) {
            frame.graph.output(frame.targets[i]);
            continue;
        }
        const ScreenTarget target = readTarget(shape, i);
        frame.pixels.push_back(frame.graph.importBuffer(pixelsName(target), pixelBytes(target, shape)));
        passes::readBack(frame.graph, frame.targets[i], {target.format, shape.extent, 1, shape.choice.views},
                         frame.pixels.back());
    }
}

/// Where the host reads the frame's targets.
std::vector<gpu::Buffer> bindPixels(const gpu::Device& device, DeclaredFrame& declared) {
    std::vector<gpu::Buffer> pixels;
    for (std::size_t i = 0; i < declared.frame.pixels.size(); ++i) {
        const ScreenTarget target = readTarget(declared.shape, i);
        pixels.push_back(gpu::makeBuffer(device, pixelBytes(target, declared.shape),
                                         vk::BufferUsageFlagBits::eTransferDst, gpu::Access::readback,
                                         pixelsName(target)));
        declared.imports.bind(declared.frame.pixels[i], pixels.back());
    }
    return pixels;
}

}  // namespace

/// Pixels of a picture's frame per pixel side of the picture.
std::uint32_t PictureFrames::samplesPerSide(const RenderSettings& settings) {
    return std::max(settings.supersample, 1u);
}

const std::shared_ptr<DeclaredFrame>& PictureFrames::declare(const PreparedFrame& prepared) {
    return declared_.of(prepared.shape, [&](Frame& frame) { declareEnding(frame, prepared.shape, picture_); });
}

/// Prepares a frame, and counts its fragments if the settings ask for it.
PreparedFrame PictureFrames::prepare(const FrameRequest& request, FrameInputs inputs) {
    FrameRequest counted = request;
    counted.quarterTurns = inputs.view.quarterTurns;
    counted.counted = request.settings.tuning.countFragments;
    if (counted.counted) inputs.fragments = std::make_shared<passes::FragmentCounter>(device_);
    PreparedFrame prepared = frames_.prepare(counted, inputs);
    if (request.part == Part::whole || request.part == Part::layers || request.part == Part::color)
        asked_ = Asked{request.settings.ofFrame(),
                       request.part,
                       request.ending,
                       counted.quarterTurns,
                       counted.counted,
                       counted.eyes,
                       prepared.facts,
                       prepared.choice()};
    return prepared;
}

PictureFrames::Drawn PictureFrames::run(PreparedFrame prepared, const RenderSettings& settings) {
    Drawn drawn;
    picture_.tiles = prepared.view->tiles.get();
    const std::shared_ptr<DeclaredFrame> declared = declare(prepared);
    SceneFrames::bind(*declared, prepared);
    if (declared->frame.picture) declared->imports.bind(*declared->frame.picture, picture_.image);
    if (declared->frame.finer) declared->imports.bind(*declared->frame.finer, picture_.finer);
    drawn.colors = prepared.colors();
    drawn.pixels = bindPixels(device_, *declared);
    const auto start = Clock::now();
    const std::shared_ptr<passes::FragmentCounter> fragments = prepared.view->fragments;
    const auto upload = std::exchange(upload_, std::nullopt);
    auto reading = std::exchange(reading_, std::nullopt);
    const auto copy = [&](gpu::CommandBuffer& c, const auto& copied) {
        executor_.record(c, copied.graph, graph::compile(copied.graph, device_.caps().plan), copied.imports, sets_);
    };
    const auto record = [&](gpu::CommandBuffer& c) {
        if (upload) copy(c, *upload);
        executor_.record(c, *declared->recording, declared->imports, settings.tuning.timePasses ? &timer_ : nullptr);
        if (fragments) fragments->finish(*c);
        if (reading) copy(c, *reading);
    };
    device_.submitAndWait(record, gpu::Device::Ends::frame);
    stats_.frameMilliseconds = millisecondsSince(start);
    executor_.reset();
    if (reading) read_ = std::move(reading->drawn);
    for (const gpu::Buffer& pixels : drawn.pixels) pixels.invalidate();
    if (drawn.colors) drawn.colors->pixels().invalidate();
    if (fragments) stats_.passes = fragments->counts();
    if (settings.tuning.timePasses) stats_.passTimes = timer_.times();
    if (last_ != declared) planText_.clear();
    last_ = declared;
    note(prepared);
    counts_ = std::move(prepared.counts);
    return drawn;
}

/// Records the last frame for stats().
void PictureFrames::note(const PreparedFrame& prepared) {
    const graph::Plan& plan = last_->plan;
    stats_.tileBytesPerPixel = graph::tileBytesPerPixel(plan);
    stats_.loadedBytes = plan.total.loaded;
    stats_.storedBytes = plan.total.stored;
    stats_.deviceBytes = device_.memory().peakBytes();
    stats_.deviceBytesHeld = device_.memory().bytes();
    const graph::GeometryCaps& caps = device_.caps().plan.geometry;
    const passes::SceneView& view = *prepared.view;
    tellGeometry(last_->frame.graph, prepared.counts, caps, view.plates, view.impostor, stats_.geometry);
    stats_.storesVaryings = caps.storesVaryings;
}

const std::string& PictureFrames::planText() {
    if (planText_.empty() && last_) planText_ = graph::describe(last_->frame.graph, last_->plan);
    return planText_;
}

std::vector<Decision> PictureFrames::decisions() const {
    if (!asked_) return {};
    return explain(
        {asked_->settings, asked_->part, asked_->ending, asked_->quarterTurns, asked_->counted, asked_->eyes},
        asked_->facts, device_.caps(), asked_->drawn);
}

/// @throws Error if the view exceeds the device's limits
void PictureFrames::checkSize(const View& view) const {
    const std::uint32_t most = device_.caps().maxImageSize;
    if (std::max(view.width, view.height) > most)
        throw Error("picture too large", std::to_string(view.width) + "x" + std::to_string(view.height),
                    "this device draws at most " + std::to_string(most) + " pixels per side, supersampling included");
}

/// A frame's pixels in host memory, and the number of pixels per row.
/// @param view  at the device's resolution divided by n
std::pair<const std::byte*, std::uint32_t> PictureFrames::pictureRows(const Drawn& drawn, const View& view,
                                                                      std::uint32_t n) {
    if (drawn.colors) return {drawn.colors->pixels().mapped, drawn.colors->rowPixels()};
    return {drawn.pixels[0].mapped, imageExtent(view).width * n};
}

/// All pixels of a view.
PictureFrames::Wanted PictureFrames::wholePicture(const RenderSettings& settings) {
    const graph::Extent image = imageExtent(settings.view);
    return {settings.view, {0, 0, image.width, image.height}};
}

/// Draws a picture's frames. @returns its pixels; with several samples each, if the host averages them
PictureFrames::Drawn PictureFrames::draw(const RenderSettings& settings, const passes::Atlas& atlas,
                                         const Wanted& wanted, Ending ending) {
    const std::uint32_t n = samplesPerSide(settings);
    const View view = scaled(wanted.view, n);
    checkSize(view);
    PreparedFrame first = prepare({settings, Part::whole, ending}, {atlas, view});
    const FrameChoice choice = first.choice();
    const bool lens = choice.has(Effect::Kind::lens);
    const bool refined = choice.refinement != Refinement::none;
    stats_.frames = 1;
    stats_.samples = refined ? RenderSettings::kEdgeSamples : choice.samples.count;
    Drawn drawn;
    if (refined) {
        const graph::Extent image = imageExtent(wanted.view);
        refine(settings, atlas, lens ? Wanted{wanted.view, {0, 0, image.width, image.height}} : wanted,
               std::move(first), ending);
    } else {
        if (lens) endInPicture(first, wanted.view, n);
        drawn = run(std::move(first), settings);
    }
    if (lens) return blur(settings, wanted);
    if (refined && ending == Ending::readBack) return readPicture();
    return drawn;
}

Picture PictureFrames::picture(const RenderSettings& settings, const passes::Atlas& atlas) {
    return picture(settings, atlas, wholePicture(settings));
}

Picture PictureFrames::picture(const RenderSettings& settings, const passes::Atlas& atlas, const Wanted& wanted) {
    const Drawn drawn = draw(settings, atlas, wanted, Ending::readBack);
    const std::uint32_t n = hasLens(settings) ? 1 : samplesPerSide(settings);
    const auto [pixels, rowPixels] = pictureRows(drawn, wanted.view, n);
    const ResolvedPart part{rowPixels, n, wanted.inner};
    Picture picture = emptyPicture(wanted.inner.width, wanted.inner.height);
    const bool fine = settings.fine && settings.debug == DebugView::none;
    const std::uint64_t samples = fine ? resolvePixels(reinterpret_cast<const float*>(pixels), part, picture)
                                       : resolvePixels(reinterpret_cast<const std::uint32_t*>(pixels), part, picture);
    const std::uint64_t covered = putOver(picture, settings.background);
    stats_.coveredPixels = wantsEdges(settings) ? covered : samples;
    return picture;
}

bool PictureFrames::drawsBoth(const FrameRequest& request) const {
    return request.settings.view.other && choose(request, frames_.facts(request.settings), device_.caps()).views > 1;
}

/// Draws both eyes of a view in one frame.
PictureFrames::Drawn PictureFrames::drawBoth(const FrameRequest& request, const passes::Atlas& atlas) {
    const View view = scaled(request.settings.view, samplesPerSide(request.settings));
    checkSize(view);
    stats_.frames = 1;
    PreparedFrame prepared = prepare(request, {atlas, view});
    stats_.samples = prepared.choice().samples.count;
    return run(std::move(prepared), request.settings);
}

std::array<Picture, 2> PictureFrames::eyes(const RenderSettings& settings, const passes::Atlas& atlas) {
    const FrameRequest request{
        settings, Part::whole, Ending::readBack, settings.view.quarterTurns, settings.tuning.countFragments, true};
    std::array<Picture, 2> eyes;
    if (!drawsBoth(request)) {
        RenderSettings one = settings;
        one.view.other.reset();
        eyes[0] = picture(one, atlas);
        one.view = otherView(settings.view);
        eyes[1] = picture(one, atlas);
        asked_->eyes = true;
        return eyes;
    }
    const std::uint32_t n = samplesPerSide(settings);
    const Drawn drawn = drawBoth(request, atlas);
    const Wanted wanted = wholePicture(settings);
    const ResolvedPart part{imageExtent(scaled(settings.view, n)).width, n, wanted.inner};
    const bool fine = settings.fine && settings.debug == DebugView::none;
    const std::size_t bytes = drawn.pixels[0].size / 2;
    std::uint64_t covered = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::byte* pixels = drawn.pixels[0].mapped + i * bytes;
        eyes[i] = emptyPicture(wanted.inner.width, wanted.inner.height);
        covered += fine ? resolvePixels(reinterpret_cast<const float*>(pixels), part, eyes[i])
                        : resolvePixels(reinterpret_cast<const std::uint32_t*>(pixels), part, eyes[i]);
        putOver(eyes[i], settings.background);
    }
    stats_.coveredPixels = covered;
    return eyes;
}

CodedPicture PictureFrames::coded(RenderSettings settings, const passes::Atlas& atlas, bool alpha) {
    settings.fine = false;
    const Wanted wanted = wholePicture(settings);
    if (samplesPerSide(settings) > 1 && !hasLens(settings))
        return nacre::coded(picture(settings, atlas, wanted), alpha);
    const Drawn drawn = draw(settings, atlas, wanted, Ending::readBack);
    const auto [pixels, rowPixels] = pictureRows(drawn, wanted.view, 1);
    return codePixels(reinterpret_cast<const std::uint32_t*>(pixels), {rowPixels, 1, wanted.inner}, settings.background,
                      alpha, stats_.coveredPixels);
}

void PictureFrames::frame(const RenderSettings& settings, const passes::Atlas& atlas) {
    const FrameRequest both{settings, Part::whole, Ending::left, 0, settings.tuning.countFragments, true};
    if (!settings.view.other) return void(draw(settings, atlas, wholePicture(settings), Ending::left));
    if (drawsBoth(both)) return void(drawBoth(both, atlas));
    RenderSettings one = settings;
    for (const View& view : {settings.view, otherView(settings.view)}) {
        one.view = view;
        one.view.other.reset();
        draw(one, atlas, wholePicture(one), Ending::left);
    }
    asked_->eyes = true;
}

}  // namespace nacre
