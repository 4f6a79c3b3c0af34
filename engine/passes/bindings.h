#pragma once
// Short names for bindings of passes and the stages that read them.

#include <algorithm>
#include <array>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::passes {

using Type = vk::DescriptorType;
constexpr Type kSampled = Type::eCombinedImageSampler, kStorage = Type::eStorageBuffer,
               kTexel = Type::eUniformTexelBuffer;
constexpr vk::ShaderStageFlags kDraw = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
constexpr auto kCompute = vk::ShaderStageFlagBits::eCompute;

/// As above, for devices that read streams from storage buffers instead of texel buffers.
template <std::size_t N>
constexpr std::array<Type, N> asStorage(std::array<Type, N> types) {
    std::replace(types.begin(), types.end(), kTexel, kStorage);
    return types;
}

}  // namespace nacre::passes
