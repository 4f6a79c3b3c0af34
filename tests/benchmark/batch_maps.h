#pragma once
// Depth maps of a batch of directions, drawn in one submission in three ways by the same shader, on a device of its own
// (the renderer's asks for no multiview).

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "engine/scene/build/representation.h"

namespace nacre::test {

enum class BatchWay {
    tiles,      ///< side by side in one image, a viewport and a draw call each
    layers,     ///< layers of one image, a render pass and a draw call each
    multiview,  ///< layers of one image, six by each render pass and its one draw call
};

class BatchMaps {
public:
    static constexpr std::uint32_t kMaps = 12, kViews = 6, kAcross = 4;

    /// @param directions  kMaps rotations
    /// @param pixels  across a map
    /// @throws std::runtime_error if the device that the environment names has no multiview
    BatchMaps(const Representation& scene, std::span<const glm::dmat3> directions, std::uint32_t pixels);

    /// Records, submits and waits.
    void draw(BatchWay way) const;
    /// Draws, and reads back: map after map, row after row, pixels x pixels values 0..1 each.
    std::vector<float> depths(BatchWay way) const;

private:
    struct Image {
        vk::raii::DeviceMemory memory{nullptr};
        vk::raii::Image handle{nullptr};
        std::vector<vk::raii::ImageView> views;
    };
    struct Buffer {
        vk::raii::DeviceMemory memory{nullptr};
        vk::raii::Buffer handle{nullptr};
        void* mapped = nullptr;
    };
    vk::raii::DeviceMemory allocate(const vk::MemoryRequirements& needs, vk::MemoryPropertyFlags wanted) const;
    Buffer buffer(vk::DeviceSize bytes, vk::BufferUsageFlags usage) const;
    Image image(std::uint32_t width, std::uint32_t height, std::uint32_t layers, std::uint32_t layersPerView) const;
    vk::raii::RenderPass renderPass(std::uint32_t viewMask) const;
    vk::raii::Pipeline pipeline(bool multiview) const;
    void makeFramebuffers();
    void record(const vk::raii::CommandBuffer& commands, BatchWay way) const;
    void recordDraw(const vk::raii::CommandBuffer& commands, std::uint32_t map, bool tiled) const;
    template <typename Record>
    void submit(Record&& record) const;

    double radius_;
    std::uint32_t pixels_, spheres_;
    vk::raii::Context context_;
    vk::raii::Instance instance_{nullptr};
    vk::raii::PhysicalDevice physical_{nullptr};
    vk::raii::Device device_{nullptr};
    vk::raii::Queue queue_{nullptr};
    vk::raii::CommandPool commands_{nullptr};
    Buffer shapes_, directions_;
    Image tiles_, layers_, sixes_;
    vk::raii::RenderPass single_{nullptr}, multi_{nullptr};
    std::vector<vk::raii::Framebuffer> framebuffers_;  // of the tiles, of each layer, of each six
    vk::raii::DescriptorSetLayout setLayout_{nullptr};
    vk::raii::PipelineLayout layout_{nullptr};
    vk::raii::DescriptorPool pool_{nullptr};
    vk::DescriptorSet set_;
    vk::raii::Pipeline plain_{nullptr}, multiview_{nullptr};
};

}  // namespace nacre::test
