#include "engine/frame/window_frames.h"

#include <cmath>
#include <utility>

#include "engine/frame/effects/lens/lens.h"
#include "engine/frame/picture.h"
#include "engine/passes/full_screen.h"
#include "engine/passes/read_back.h"

namespace nacre {
namespace {

using Quality = WindowFrame::Quality;

/// Format of sample sums: blendable on every device; sums sixteen samples within a quarter of an 8-bit step.
constexpr VkFormat kSumFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

/// A point of the lens for sample i: no two are close, and none is where its neighbours in a pixel are.
glm::dvec2 lensPoint(std::uint32_t samples, std::uint32_t i) {
    constexpr double kGoldenAngle = 2.399963229728653;
    const std::uint32_t k = (i * 19 + 7) % samples;
    return std::sqrt((k + 0.5) / samples) * glm::dvec2(std::cos(k * kGoldenAngle), std::sin(k * kGoldenAngle));
}

/// The view through sample i of a number of samples, in rows as in a picture. If there are many, each is far from the
/// previous ones. With a lens, each sample sees through another lens point, which blurs at no extra cost.
View throughSampleOf(const RenderSettings& settings, View view, std::uint32_t samples, std::uint32_t i) {
    if (hasLens(settings) && samples > 1) view = throughLens(settings, view, lensPoint(samples, i));
    if (samples >= RenderSettings::kEdgeSamples) i = i * 5 % samples;
    const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(samples)));
    const glm::dvec2 at = (glm::dvec2(i % side, i / side) + 0.5) / static_cast<double>(side) - 0.5;
    view.pan += glm::dvec2(-at.x, at.y) / view.pixelsPerAngstrom;
    return view;
}

/// The rectangle of an upright window's part in its image.
vk::Rect2D turned(const vk::Rect2D& r, graph::Extent upright, int quarterTurns) {
    const auto [x, y] = std::pair(r.offset.x, r.offset.y);
    const auto right = static_cast<std::int32_t>(upright.width - r.extent.width) - x;
    const auto below = static_cast<std::int32_t>(upright.height - r.extent.height) - y;
    const vk::Extent2D across(r.extent.height, r.extent.width);
    switch (quarterTurns & 3) {
        case 1:
            return {{below, x}, across};
        case 2:
            return {{right, below}, r.extent};
        case 3:
            return {{y, right}, across};
        default:
            return r;
    }
}

}  // namespace

WindowFrames::WindowFrames(const gpu::Device& device, gpu::Executor& executor, SceneFrames& frames,
                           const SurfaceSource& source)
    : device_(device),
      executor_(executor),
      frames_(frames),
      swapchain_(device, source.create),
      ring_(device),
      declared_(device.caps().plan),
      overlay_(device, executor) {
    executor_.makePipelinesAhead();
}

void WindowFrames::setGlyphs(const OverlayGlyphs& glyphs) {
    device_->waitIdle();
    overlay_.setGlyphs(executor_, glyphs);
}

void WindowFrames::release() {
    ring_.dropImage();
    executor_.forgetFramebuffers();
    swapchain_.release();
}

bool WindowFrames::coded() const {
    return swapchain_.format() == VK_FORMAT_B8G8R8A8_UNORM || swapchain_.format() == VK_FORMAT_R8G8B8A8_UNORM;
}

/// Format of pictures that are copied to the window: the window's own if possible, so that both share one set of
/// pipelines.
VkFormat WindowFrames::pictureFormat() const { return coded() ? VK_FORMAT_R8G8B8A8_SRGB : swapchain_.format(); }

/// Adapts swapchain and kept picture to the window's size. @returns whether there is anything to draw into
bool WindowFrames::resize(graph::Extent wanted) {
    if (!swapchain_.stale() && swapchain_.ready() && swapchain_.upright() == wanted) return true;
    if (swapchain_.retires()) {
        if (const auto image = ring_.skipImage()) swapchain_.giveBack(*image);
        executor_.retireFramebuffers(retired_);
        retired_.others.push_back(swapchain_.drawnInto());
    } else {
        ring_.dropImage();
        executor_.forgetFramebuffers();
    }
    swapchain_.recreate(wanted);
    return swapchain_.ready();
}

/// The pass that brings a picture onto the window.
graph::Image WindowFrames::addPicture(graph::Graph& frame, graph::Image picture, std::uint32_t samples) const {
    graph::Image window = frame.importImage("window", {swapchain_.format(), swapchain_.extent()}, kWindowState, true);
    const auto how = [=, this] { return passes::Resampling{samples, coded(), share_, false}; };
    frame.graphics("resample")
        .samples(picture)
        .color(window)
        .record({[=](gpu::PassContext& c) { passes::resample(c, c.view(picture), how()); },
                 [=](gpu::PipelineContext& c) { passes::wantResampling(c, how()); }});
    return window;
}

/// The pass that adds a sample of each pixel to the sum; for each view one. @returns the sum, to be bound
/// @param eye  whether the sample is of one eye or of both (ofEyes_), not of the whole window
graph::Image WindowFrames::addSum(graph::Graph& frame, graph::Image sample, bool first, bool eye,
                                  std::uint32_t views) const {
    graph::Image sum =
        frame.importImage("sum of samples", {kSumFormat, swapchain_.extent()}, passes::kTextureState, first);
    for (std::uint32_t i = 0; i < views; ++i) {
        std::optional<graph::Clear> clear;
        if (first && i == 0) clear = graph::Clear{0.0f};
        const auto how = [=, this] {
            passes::Resampling added{1, false, 1, true};
            if (eye) added = ofEyes_[views > 1 ? i : eye_];
            if (views > 1) added.layer = i;
            return added;
        };
        frame.graphics(i == 0 ? "sum of samples" : "sum of the other eye's samples")
            .samples(sample)
            .color(sum, clear)
            .record({[=](gpu::PassContext& c) { passes::resample(c, c.view(sample), how()); },
                     [=](gpu::PipelineContext& c) { passes::wantResampling(c, how()); }});
    }
    return sum;
}

/// @param samples  attachment with several samples, resolved to the window after the overlay; none: drawn directly
void WindowFrames::addOverlay(graph::Graph& frame, graph::Image& window, std::optional<graph::Image>& samples) const {
    const auto draw = [this](gpu::PassContext& c) {
        overlay_.draw(c, *slot_, *overlaid_, swapchain_.upright(), swapchain_.quarterTurns(), coded());
    };
    const auto want = [this](gpu::PipelineContext& c) {
        passes::OverlayPass::want(c, swapchain_.quarterTurns(), coded());
    };
    graph::PassBuilder pass = frame.graphics("overlay");
    samples ? pass.color(*samples).resolve(window) : pass.color(window);
    pass.record({draw, want});
}

/// Makes the pipelines for smaller pictures, samples and their sum before the first of them is drawn.
void WindowFrames::prepareOthers() {
    const graph::ImageDesc desc{pictureFormat(), swapchain_.extent()};
    const auto prepare = [&](const auto& declare) {
        graph::Graph graph("ahead");
        declare(graph, graph.importImage("colour", desc, passes::kTextureState));
        executor_.prepare(graph, graph::compile(graph, device_.caps().plan));
    };
    for (const bool first : {true, false})  // a sample that begins a sum, and one that is added
        prepare([&](graph::Graph& graph, graph::Image colour) { addPicture(graph, addSum(graph, colour, first), 1); });
    prepare([&](graph::Graph& graph, graph::Image colour) { addPicture(graph, colour, 0); });
}

Ending WindowFrames::endingOf(const WindowFrame& frame) const {
    if (frame.quality == Quality::kept) return Ending::sumToWindow;
    if (frame.quality == Quality::refined) return frame.sample == 0 ? Ending::firstSample : Ending::nextSample;
    if (frame.scale != 1.0) return Ending::scaledToWindow;
    return coded() ? Ending::copiedToWindow : Ending::window;
}

/// The passes behind a scene's own. The last target is the window.
void WindowFrames::declareEnding(Frame& frame, const FrameShape& shape) {
    graph::Graph& g = frame.graph;
    const Ending ending = shape.choice.ending;
    if (ending == Ending::firstSample || ending == Ending::nextSample)
        frame.sum = addSum(g, frame.targets[0], ending == Ending::firstSample, shape.eye, shape.choice.views);
    if (shape.eye) return;
    if (ending == Ending::sumToWindow)
        frame.sum = g.importImage("sum of samples", {kSumFormat, swapchain_.extent()}, passes::kTextureState);
    if (ending == Ending::copiedToWindow || ending == Ending::scaledToWindow)
        frame.targets.push_back(addPicture(g, frame.targets[0], ending == Ending::copiedToWindow ? 1 : 0));
    if (frame.sum) frame.targets.push_back(addPicture(g, *frame.sum, 1));
    std::optional<graph::Image> none;
    if (shape.overlay) addOverlay(g, frame.targets.back(), ending == Ending::window ? frame.samples : none);
}

/// Creates the image of sample sums, of the window's size.
void WindowFrames::makeSum() {
    const graph::ImageDesc desc{kSumFormat, swapchain_.extent()};
    if (sum_.desc == desc) return;
    executor_.retireFramebuffers(retired_);
    retired_.images.push_back(std::move(sum_));
    sum_ = gpu::makeImage(device_, desc, vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled,
                          false, "sum of samples");
}

/// Prepares the scene for the frame, and the frame's shape.
/// @param radiusBefore  as in FrameInputs
PreparedFrame WindowFrames::prepare(const RenderSettings& settings, const passes::Atlas& atlas,
                                    const WindowFrame& frame, std::optional<double> radiusBefore,
                                    std::optional<std::size_t> eye) {
    PreparedFrame prepared;
    View view = eye ? (*frame.eyes)[*eye].view : settings.view;
    view.quarterTurns = swapchain_.quarterTurns();
    Ending ending = endingOf(frame);
    if (eye && (*eye > 0 || frame.quality == Quality::live))
        ending = *eye > 0 ? Ending::nextSample : Ending::firstSample;
    const graph::Clear clear = opaqueClear(settings.background);
    target_ = {"colour", pictureFormat(), passes::Output::color, "impostor colour", clear};
    RenderSettings drawn = settings.ofFrame();
    if (eye) drawn.view = (*frame.eyes)[*eye].view;
    const auto prepareAs = [&](Part part, const char* name) {
        FrameInputs inputs{atlas, view, name};
        inputs.window = {&target_, 1};
        inputs.radiusBefore = radiusBefore;
        prepared = frames_.prepare({drawn, part, ending, view.quarterTurns, false, eye && view.other}, inputs);
    };
    if (ending == Ending::sumToWindow) {
        prepared.shape.name = "kept screen";
        prepared.shape.choice.ending = ending;
    } else if (frame.quality == Quality::refined) {
        view = throughSampleOf(drawn, view, frame.samples, frame.sample);
        prepareAs(Part::sample, "refinement");
    } else {
        drawn.supersample = 1;
        drawn.meshError = frame.meshError * settings.meshError;
        const bool direct = ending == Ending::window;
        if (direct) target_ = {"window", swapchain_.format(), target_.output, target_.pass, clear, &kWindowState};
        view = scaled(view, frame.scale);
        prepareAs(Part::motion, direct ? "screen" : eye ? "eye" : "scaled screen");
    }
    prepared.shape.window = swapchain_.extent();
    prepared.shape.eye = eye.has_value();
    prepared.shape.overlay = frame.overlay && !frame.overlay->batches.empty();
    return prepared;
}

DeclaredFrame& WindowFrames::declared(const PreparedFrame& prepared) {
    return *declared_.of(prepared.shape, [&](Frame& f) { declareEnding(f, prepared.shape); });
}

void WindowFrames::prepareScene(const RenderSettings& settings, const WindowFrame& frame) {
    if (!swapchain_.ready()) return;
    WindowFrame first = frame;
    first.quality = Quality::live;
    const PreparedFrame prepared = prepare(settings, {}, first, {});
    DeclaredFrame& wanted = declared(prepared);
    SceneFrames::bind(wanted, prepared);
    executor_.prepare(wanted.frame.graph, wanted.plan);
}

/// Makes the pipelines of a window at rest while frames in motion, which have several samples, use others.
void WindowFrames::prepareRest(const RenderSettings& settings, const passes::Atlas& atlas, const WindowFrame& frame) {
    WindowFrame still;
    still.quality = Quality::refined;
    still.samples = RenderSettings::kEdgeSamples;
    still.eyes = frame.eyes;
    const PreparedFrame prepared = prepare(settings, atlas, still, counts_.radiusPixels,
                                           frame.eyes ? std::optional<std::size_t>(0) : std::nullopt);
    DeclaredFrame& wanted = declared(prepared);
    SceneFrames::bind(wanted, prepared);
    executor_.prepare(wanted.frame.graph, wanted.plan);
}

/// Records a prepared frame.
void WindowFrames::draw(gpu::FrameSlot& slot, const PreparedFrame& prepared, const WindowFrame& frame) {
    if (prepared.view) counts_ = prepared.counts;
    DeclaredFrame& declared = this->declared(prepared);
    // Frames of two eyes take turns: the first tells.
    if (prepared.choice().attachmentSamples() > 1 && (!prepared.shape.eye || eye_ == 0))
        restWanted_ = std::exchange(multisampled_, &declared) != &declared;
    if (prepared.view)
        SceneFrames::bind(declared, prepared);
    else
        declared.imports.clear();
    if (!prepared.shape.eye) declared.imports.bind(declared.frame.targets.back(), swapchain_.image(*slot.image));
    share_ = 1;
    if (declared.frame.sum) {
        if (prepared.view) makeSum();
        declared.imports.bind(*declared.frame.sum, sum_);
        share_ = 1.0f / static_cast<float>(prepared.view ? frame.sample + 1 : summed_);
    }
    executor_.record(slot.commands, *declared.recording, declared.imports, slot.descriptors, nullptr, &retired_);
    if (slot.timed) slot.timer.lap(*slot.commands, declared.frame.graph.name());
}

/// Adds the pictures of both eyes to the sum, each in its part of the window.
void WindowFrames::drawEyes(gpu::FrameSlot& slot, const RenderSettings& settings, const passes::Atlas& atlas,
                            const WindowFrame& frame) {
    const bool live = frame.quality == Quality::live;
    for (std::size_t i = 0; i < ofEyes_.size(); ++i) {
        const auto& [view, x, y, channels] = (*frame.eyes)[i];
        ofEyes_[i] = {live && frame.scale != 1.0 ? 0u : 1u, false, 1, true};
        ofEyes_[i].part = turned({{x, y}, {view.width, view.height}}, swapchain_.upright(), swapchain_.quarterTurns());
        ofEyes_[i].channels = channels;
    }
    slot.held = {};
    for (eye_ = 0; eye_ < ofEyes_.size(); ++eye_) {
        const PreparedFrame prepared = prepare(settings, atlas, frame, counts_.radiusPixels, eye_);
        slot.held[eye_] = prepared.view;
        draw(slot, prepared, frame);
        if (prepared.choice().views > 1) break;
    }
    eye_ = 0;
    summed_ = live ? 1 : frame.sample + 1;
}

/// Draws the frame into the slot's image.
void WindowFrames::submit(gpu::FrameSlot& slot, const RenderSettings& settings, const passes::Atlas& atlas,
                          const WindowFrame& frame) {
    WindowFrame shown = frame;
    const bool eyes = frame.eyes && frame.quality != Quality::kept;
    PreparedFrame prepared;
    if (!eyes) {
        prepared = prepare(settings, atlas, shown, counts_.radiusPixels);
        slot.held = {prepared.view, nullptr};
    }
    slot_ = &slot;
    overlaid_ = frame.overlay;
    if (frame.overlay && !frame.overlay->batches.empty()) overlay_.upload(slot, *frame.overlay);
    device_.log().begin();
    slot.commands.reset();
    slot.commands.begin();
    // Only live frames pace resolution and bake. Over Metal each timestamp needs an encoder.
    slot.timed = frame.quality == Quality::live;
    if (slot.timed) slot.timer.begin(*slot.commands);
    if (eyes) {
        drawEyes(slot, settings, atlas, frame);
        shown.quality = Quality::kept;
        prepared = prepare(settings, atlas, shown, {});
    }
    draw(slot, prepared, shown);
    slot.commands.end();
    ring_.submit(slot, swapchain_.drawn(*slot.image));
    slot.retired = std::exchange(retired_, {});  // used by earlier submissions
}

void WindowFrames::await() {
    if (swapchain_.stale() || !swapchain_.ready()) return;
    gpu::FrameSlot& slot = ring_.next();
    if (!slot.image) slot.image = swapchain_.acquire(*slot.acquired);
}

FrameOutcome WindowFrames::present(const RenderSettings& settings, const passes::Atlas& atlas,
                                   const WindowFrame& frame) {
    const graph::Extent wanted{settings.view.width, settings.view.height};
    for (int attempt = 0; attempt < 3; ++attempt) {
        if (!resize(wanted)) return FrameOutcome::hidden;
        if (swapchain_.upright() != wanted) return FrameOutcome::resized;
        const std::uint32_t there = sum_.desc.extent == swapchain_.extent() ? summed_ : 0;
        if (frame.quality == Quality::kept && there == 0) return FrameOutcome::resized;
        if (frame.quality == Quality::refined && frame.sample > 0 && there != frame.sample)
            return FrameOutcome::resized;
        gpu::FrameSlot& slot = ring_.next();
        // A failed attempt may have left an image in the slot.
        if (!slot.image) slot.image = swapchain_.acquire(*slot.acquired);
        if (!slot.image) continue;
        const std::uint32_t index = *slot.image;
        if (frame.quality != Quality::kept) summed_ = 0;  // after a failure midway the state is unknown
        submit(slot, settings, atlas, frame);
        if (frame.quality == Quality::refined) summed_ = frame.sample + 1;
        if (frame.quality == Quality::live && frame.eyes) summed_ = 0;  // the sum holds the eyes
        swapchain_.present(index);
        if (!std::exchange(preparedOthers_, true)) prepareOthers();
        if (std::exchange(restWanted_, false)) prepareRest(settings, atlas, frame);
        return FrameOutcome::shown;
    }
    return FrameOutcome::resized;  // the window resizes too fast: try again at the next frame
}

}  // namespace nacre
