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

/// A point of the lens for sample i: no two are close, and none is where its neighbours in a pixel are.
glm::dvec2 lensPoint(std::uint32_t samples, std::uint32_t i) {
    constexpr double kGoldenAngle = 2.399963229728653;
    const std::uint32_t k = (i * 19 + 7) % samples;
    return std::sqrt((k + 0.5) / samples) * glm::dvec2(std::cos(k * kGoldenAngle), std::sin(k * kGoldenAngle));
}

/// The view through sample i of a number of samples, in rows as in a picture. If there are many, each is far from the
/// previous ones. With a lens, each sample sees through another lens point, which blurs at no extra cost.
View shiftToSample(const RenderSettings& settings, View view, std::uint32_t samples, std::uint32_t i) {
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
      swapchain_(device, source),
      ring_(device),
      declared_(device.caps().plan),
      overlay_(device, executor) {
    executor_.makePipelinesAhead();
}

void WindowFrames::setGlyphs(const OverlayGlyphs& glyphs) {
    device_.waitIdle();
    overlay_.setGlyphs(executor_, glyphs);
}

void WindowFrames::release() {
    ring_.dropImage();
    executor_.forgetFramebuffers();
    swapchain_.release();
}

WindowEnd WindowFrames::end() const {
    WindowEnd end{swapchain_.format(), &samples_};
    end.overlay = {[this, coded = end.coded()](gpu::PassContext& c) {
                       overlay_.draw(c, *slot_, *overlaid_, swapchain_.upright(), swapchain_.quarterTurns(), coded);
                   },
                   [this, coded = end.coded()](gpu::PipelineContext& c) {
                       passes::OverlayPass::want(c, swapchain_.quarterTurns(), coded);
                   }};
    return end;
}

/// Format of pictures that are copied to the window: the window's own if possible, so that both share one set of
/// pipelines.
VkFormat WindowFrames::pictureFormat() const { return end().coded() ? VK_FORMAT_R8G8B8A8_SRGB : swapchain_.format(); }

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

/// Creates the pipelines that show a smaller picture and the kept sum, before the first is shown.
void WindowFrames::prepareOthers() {
    const graph::Extent window = swapchain_.extent();
    const auto prepare = [&](VkFormat format, const auto& add) {
        graph::Graph graph("ahead");
        add(graph, graph.importImage("picture", {format, window}, passes::kTextureState));
        executor_.prepare(graph, graph::compile(graph, device_.caps().plan));
    };
    prepare(pictureFormat(), [&](graph::Graph& g, graph::Image picture) { end().addPicture(g, picture, window, 0); });
    prepare(kSumFormat, [&](graph::Graph& g, graph::Image sum) { end().addShownSum(g, sum, window); });
}

Ending WindowFrames::chooseEnding(const WindowFrame& frame) const {
    if (frame.quality == Quality::kept) return Ending::sumToWindow;
    if (frame.quality == Quality::refined) return frame.sample == 0 ? Ending::firstSample : Ending::nextSample;
    if (frame.scale != 1.0) return Ending::scaledToWindow;
    return end().coded() ? Ending::copiedToWindow : Ending::window;
}

/// Creates the image of sample sums, of the window's size.
void WindowFrames::makeSum() {
    const graph::ImageDesc desc{kSumFormat, swapchain_.extent()};
    if (sum_.desc == desc) return;
    executor_.retireFramebuffers(retired_);
    retired_.images.push_back(std::move(sum_));
    sum_ = gpu::makeImage(device_, desc,
                          vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled |
                              vk::ImageUsageFlagBits::eInputAttachment,
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
    Ending ending = chooseEnding(frame);
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
        view = shiftToSample(drawn, view, frame.samples, frame.sample);
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
    return *declared_.of(prepared.shape, [&](Frame& f) { end().declare(f, prepared.shape); });
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

/// Creates the pipelines of a window at rest: its render pass has other attachments than one of frames in motion.
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
    if (prepared.view)
        SceneFrames::bind(declared, prepared);
    else
        declared.imports.clear();
    if (!prepared.shape.eye) declared.imports.bind(declared.frame.targets.back(), swapchain_.image(*slot.image));
    samples_.share = 1;
    if (declared.frame.sum) {
        if (prepared.view) makeSum();
        declared.imports.bind(*declared.frame.sum, sum_);
        samples_.share = 1.0f / static_cast<float>(prepared.view ? frame.sample + 1 : summed_);
    }
    executor_.record(slot.commands, *declared.recording, declared.imports, slot.descriptors, nullptr, &retired_);
    if (slot.timed) slot.timer.lap(*slot.commands, declared.frame.graph.name());
}

/// Adds the pictures of both eyes to the sum, each in its part of the window.
void WindowFrames::drawEyes(gpu::FrameSlot& slot, const RenderSettings& settings, const passes::Atlas& atlas,
                            const WindowFrame& frame) {
    const bool live = frame.quality == Quality::live;
    for (std::size_t i = 0; i < samples_.ofEyes.size(); ++i) {
        const auto& [view, x, y, channels] = (*frame.eyes)[i];
        samples_.ofEyes[i] = {live && frame.scale != 1.0 ? 0u : 1u, false, 1, true};
        samples_.ofEyes[i].part =
            turned({{x, y}, {view.width, view.height}}, swapchain_.upright(), swapchain_.quarterTurns());
        samples_.ofEyes[i].channels = channels;
    }
    slot.held = {};
    for (samples_.eye = 0; samples_.eye < samples_.ofEyes.size(); ++samples_.eye) {
        const PreparedFrame prepared = prepare(settings, atlas, frame, counts_.radiusPixels, samples_.eye);
        slot.held[samples_.eye] = prepared.view;
        draw(slot, prepared, frame);
        if (prepared.choice().views > 1) break;
    }
    samples_.eye = 0;
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
    if (slot.image) return;  // the frame has waited
    swapchain_.awaitDisplay();
    if (!swapchain_.stale()) slot.image = swapchain_.acquire(*slot.acquired);
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
        // A scene that needed new pipelines in motion needs others at rest.
        const bool newPipelines = std::exchange(pipelines_, executor_.pipelines()) != executor_.pipelines();
        if (newPipelines && frame.quality == Quality::live) prepareRest(settings, atlas, frame);
        return FrameOutcome::shown;
    }
    return FrameOutcome::resized;  // the window resizes too fast: try again at the next frame
}

}  // namespace nacre
