#pragma once
// What passes bind, and the stages that read it, by short names.

#include <vulkan/vulkan_raii.hpp>

namespace nacre::passes {

using Type = vk::DescriptorType;
constexpr Type kSampled = Type::eCombinedImageSampler, kStorage = Type::eStorageBuffer,
               kTexel = Type::eUniformTexelBuffer;
constexpr vk::ShaderStageFlags kDraw = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
constexpr auto kCompute = vk::ShaderStageFlagBits::eCompute;

}  // namespace nacre::passes
