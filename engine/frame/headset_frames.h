#pragma once
// Frames for a headset: draws both eyes into the layers of an image of its runtime.

#include <array>
#include <list>
#include <memory>

#include "engine/frame/declared_frames.h"
#include "engine/frame/foveation.h"
#include "engine/frame/scene_frames.h"
#include "engine/gpu/frame_ring.h"

namespace nacre {

class HeadsetFrames {
public:
    /// All arguments must outlive this.
    HeadsetFrames(const gpu::Device& device, gpu::Executor& executor, SceneFrames& frames);
    ~HeadsetFrames() { device_.settle(); }

    /// As Renderer::presentEyes.
    void present(const RenderSettings& settings, const passes::Atlas& atlas, const std::array<View, 2>& eyes,
                 const HeadsetImage& into);
    /// GPU time of a recent frame, milliseconds; 0: unknown.
    double milliseconds() const { return ring_.milliseconds(); }
    /// Counts of the last frame.
    const SceneCounts& counts() const { return counts_; }

private:
    struct Layers {
        VkImage image{};
        vk::raii::ImageView both{nullptr};
        std::array<vk::raii::ImageView, 2> each{vk::raii::ImageView{nullptr}, vk::raii::ImageView{nullptr}};
    };
    /// A map of fragment densities, and the eyes that it is for.
    struct Fovea {
        std::array<EyeAxis, 2> eyes;
        gpu::Image map;
        std::array<vk::raii::ImageView, 2> each{vk::raii::ImageView{nullptr}, vk::raii::ImageView{nullptr}};
    };
    const Layers& imageLayers(const HeadsetImage& image);
    const Fovea& makeFovea(const std::array<View, 2>& eyes);

    const gpu::Device& device_;
    gpu::Executor& executor_;
    SceneFrames& frames_;
    gpu::FrameRing ring_;
    gpu::Retired retired_;
    DeclaredFrames declared_;
    SceneCounts counts_;
    std::list<Layers> images_;  ///< of the runtime's swapchain
    std::shared_ptr<const Fovea> fovea_;
};

}  // namespace nacre
