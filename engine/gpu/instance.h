#pragma once

#include <memory>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "engine/gpu/validation_log.h"

namespace nacre::gpu {

struct InstanceExtensions {
    bool debugUtils = false, portability = false;
    bool surfaceMaintenance = false;  ///< if any were wanted: those of a window
};

/// @param wanted extensions besides those that the engine itself takes
/// @throws Error if there is no loader or driver, an extension is missing, or validation is asked for and not installed
vk::raii::Instance makeInstance(const vk::raii::Context& context, bool validate, InstanceExtensions& found,
                                const std::vector<std::string>& wanted = {});

/// Collects validation messages of warning severity and above, for as long as the messenger lives.
vk::raii::DebugUtilsMessengerEXT makeMessenger(const vk::raii::Instance& instance, ValidationLog& messages);

/// The device that a number or part of a name means; empty: discrete, integrated, virtual, then software.
/// @throws Error that lists what there is
vk::raii::PhysicalDevice pickDevice(const vk::raii::Instance& instance, const std::string& wanted);

}  // namespace nacre::gpu
