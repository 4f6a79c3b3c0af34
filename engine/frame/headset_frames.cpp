#include "engine/frame/headset_frames.h"

#include <algorithm>
#include <utility>

#include "engine/passes/read_back.h"

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

const HeadsetFrames::Layers& HeadsetFrames::imageLayers(const HeadsetImage& image) {
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

/// The device has written a map before a frame that it decides is recorded. Eyes keep theirs while a head moves.
const HeadsetFrames::Fovea& HeadsetFrames::makeFovea(const std::array<View, 2>& eyes) {
    const std::array<EyeAxis, 2> axes{findAxis(eyes[0]), findAxis(eyes[1])};
    if (fovea_ && std::ranges::equal(fovea_->eyes, axes, alike)) return *fovea_;
    if (fovea_) {
        executor_.retireFramebuffers(retired_);
        retired_.others.push_back(fovea_);
    }
    const std::uint32_t texel = device_.caps().plan.densityTexel;
    const graph::ImageDesc desc = densityMapFor(axes[0].image, 2, texel);
    auto fovea = std::make_shared<Fovea>(
        Fovea{axes, passes::makeTexture(device_, executor_, desc, fragmentDensities(axes, texel), "fragment density",
                                        graph::Verb::density)});
    for (std::uint32_t i = 0; i < 2; ++i)
        fovea->each[i] =
            vk::raii::ImageView(*device_, vk::ImageViewCreateInfo({}, *fovea->map.handle, vk::ImageViewType::e2D,
                                                                  static_cast<vk::Format>(desc.format), {},
                                                                  {vk::ImageAspectFlagBits::eColor, 0, 1, i, 1}));
    fovea_ = std::move(fovea);
    return *fovea_;
}

void HeadsetFrames::present(const RenderSettings& settings, const passes::Atlas& atlas, const std::array<View, 2>& eyes,
                            const HeadsetImage& into) {
    gpu::FrameSlot& slot = ring_.next();
    const Layers& layers = imageLayers(into);
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
        PreparedFrame prepared =
            frames_.prepare({drawn, Part::motion, Ending::window, 0, false, parallel, true}, inputs);
        const bool both = prepared.choice().views > 1;
        slot.held[i] = prepared.view;
        DeclaredFrame& frame = *declared_.of(prepared.shape, [](Frame&) {});
        SceneFrames::bind(frame, prepared);
        frame.imports.bind(frame.frame.targets.back(),
                           both ? gpu::ImageRef(into.image, *layers.both)
                                : gpu::ImageRef(into.image, *layers.each[i], static_cast<std::uint32_t>(i)));
        if (frame.frame.density) {
            const Fovea& fovea = makeFovea(eyes);
            frame.imports.bind(*frame.frame.density,
                               both ? gpu::ImageRef(fovea.map)
                                    : gpu::ImageRef(*fovea.map.handle, *fovea.each[i], static_cast<std::uint32_t>(i)));
        }
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
