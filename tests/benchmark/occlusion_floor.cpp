#include "tests/benchmark/occlusion_floor.h"

#include <algorithm>

namespace nacre::test {
namespace {

namespace shaders {
#include "occlusionFloor.h"
}

using Type = vk::DescriptorType;
constexpr std::uint32_t kGroup = 64;         // local_size_x
constexpr std::uint32_t kMostGroups = 4096;  // each thread goes on to the words beyond
constexpr float kDepth = 1.0f;

struct Push {
    std::uint32_t words, texels, last;
};

}  // namespace

OcclusionFloor::OcclusionFloor(const gpu::Device& device, std::uint64_t mapBytes, std::uint32_t perBatch,
                               std::uint64_t texels)
    : device_(device),
      words_(static_cast<std::uint32_t>(mapBytes / 16)),
      perBatch_(perBatch),
      texels_(static_cast<std::uint32_t>(texels)) {
    constexpr auto kStorage = vk::BufferUsageFlagBits::eStorageBuffer;
    maps_ = gpu::makeBuffer(device, mapBytes, kStorage, gpu::Access::upload, "floor's maps");
    auto* depths = reinterpret_cast<float*>(maps_.mapped);
    std::fill(depths, depths + mapBytes / sizeof(float), kDepth);
    sums_ = gpu::makeBuffer(device, texels * 8, kStorage, gpu::Access::upload, "floor's sums");
    constexpr Type kBindings[] = {Type::eStorageBuffer, Type::eStorageBuffer};
    layout_ =
        gpu::makeLayout(device, {"occlusion floor layout", kBindings, vk::ShaderStageFlagBits::eCompute, sizeof(Push)});
    pipeline_ = gpu::makePipeline(
        device, gpu::ComputePipeline{"occlusion floor", shaders::occlusionFloor, {}, *layout_.pipeline});
}

void OcclusionFloor::run(std::uint32_t directions) const {
    gpu::DescriptorPool pool(device_);
    const vk::DescriptorSet set = pool.allocate(layout_.set, "occlusion floor");
    const vk::DescriptorBufferInfo infos[] = {{*maps_.handle, 0, VK_WHOLE_SIZE}, {*sums_.handle, 0, VK_WHOLE_SIZE}};
    for (std::uint32_t i = 0; i < 2; ++i)
        device_->updateDescriptorSets(vk::WriteDescriptorSet(set, i, 0, Type::eStorageBuffer, {}, infos[i]), {});
    const std::uint32_t groups = std::min((std::max(words_, texels_) + kGroup - 1) / kGroup, kMostGroups);
    device_.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_);
        commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout_.pipeline, 0, set, {});
        for (std::uint32_t done = 0; done < directions; done += perBatch_) {
            // The last batch may have fewer maps.
            const std::uint32_t maps = std::min(perBatch_, directions - done);
            const Push push{words_ / perBatch_ * maps, texels_, done + maps == directions ? 1u : 0u};
            commands.pushConstants<Push>(*layout_.pipeline, vk::ShaderStageFlagBits::eCompute, 0, push);
            commands.dispatch(groups, 1, 1);
        }
    });
}

}  // namespace nacre::test
