#include "engine/frame/headset_frames.h"

#include <algorithm>
#include <utility>

namespace nacre {
namespace {

/// State of the runtime's images before and after a frame.
constexpr graph::State kLentState{VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, 0,
                                  VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};

/// Whether one frame can draw both eyes: the views differ only by what View::other states.
bool lookInParallel(const View& a, const View& b) {
    return a.projection == Projection::perspective && a.projection == b.projection && a.rotation == b.rotation &&
           a.eyeDistance == b.eyeDistance && a.pixelsPerAngstrom == b.pixelsPerAngstrom && a.radius == b.radius &&
           a.shift.y == b.shift.y && a.shift.z == b.shift.z && a.pan.y == b.pan.y;
}

}  // namespace

HeadsetFrames::HeadsetFrames(const gpu::Device& device, gpu::Executor& executor, SceneFrames& frames)
    : device_(device), executor_(executor), frames_(frames), ring_(device), declared_(device.caps().plan) {
    executor_.makePipelinesAhead();
}

const HeadsetFrames::Layers& HeadsetFrames::layersOf(const HeadsetImage& image) {
    const auto known = std::ranges::find(images_, image.image, &Layers::image);
    if (known != images_.end()) return *known;
    const auto view = [&](std::uint32_t first, std::uint32_t count) {
        using Type = vk::ImageViewType;
        return vk::raii::ImageView(*device_,
                                   vk::ImageViewCreateInfo({}, image.image, count > 1 ? Type::e2DArray : Type::e2D,
                                                           static_cast<vk::Format>(image.format), {},
                                                           {vk::ImageAspectFlagBits::eColor, 0, 1, first, count}));
    };
    images_.push_back({image.image, view(0, 2), {view(0, 1), view(1, 1)}});
    return images_.back();
}

void HeadsetFrames::present(const RenderSettings& settings, const passes::Atlas& atlas, const std::array<View, 2>& eyes,
                            const HeadsetImage& into) {
    gpu::FrameSlot& slot = ring_.next();
    const Layers& layers = layersOf(into);
    RenderSettings drawn = settings.ofFrame();
    drawn.supersample = 1;
    ScreenTarget target{"headset",         static_cast<VkFormat>(into.format), passes::Output::color,
                        "impostor colour", opaqueClear(settings.background),   &kLentState};
    const bool parallel = lookInParallel(eyes[0], eyes[1]);
    device_.log().begin();
    slot.commands.reset();
    slot.commands.begin();
    slot.timed = true;
    slot.timer.begin(*slot.commands);
    slot.held = {};
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        const View view = parallel && i == 0 ? paired(eyes[0], eyes[1]) : eyes[i];
        drawn.view = view;
        FrameInputs inputs{atlas, view, "headset"};
        inputs.window = {&target, 1};
        inputs.radiusBefore = counts_.radiusPixels;
        PreparedFrame prepared = frames_.prepare({drawn, Part::motion, Ending::window, 0, false, parallel}, inputs);
        const bool both = prepared.choice().views > 1;
        slot.held[i] = prepared.view;
        DeclaredFrame& frame = *declared_.of(prepared.shape, [](Frame&) {});
        SceneFrames::bind(frame, prepared);
        frame.imports.bind(frame.frame.targets.back(),
                           both ? gpu::ImageRef(into.image, *layers.both)
                                : gpu::ImageRef(into.image, *layers.each[i], static_cast<std::uint32_t>(i)));
        executor_.record(slot.commands, *frame.recording, frame.imports, slot.descriptors, nullptr, &retired_);
        counts_ = std::move(prepared.counts);
        if (both) break;
    }
    slot.timer.lap(*slot.commands, "headset");
    slot.commands.end();
    ring_.submit(slot);
    slot.retired = std::exchange(retired_, {});
}

}  // namespace nacre
