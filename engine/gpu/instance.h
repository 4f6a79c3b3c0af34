#pragma once

#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "engine/device_options.h"
#include "engine/gpu/validation_log.h"

namespace nacre::gpu {

struct InstanceExtensions {
    bool debugUtils = false, portability = false;
    // Of a window's instance:
    bool surfaceQueries = false;      ///< VK_KHR_get_surface_capabilities2
    bool surfaceMaintenance = false;  ///< VK_EXT_surface_maintenance1
};

/// Vulkan's entry point, for a headset's runtime that makes objects.
HeadsetSource::EntryPoint entryPoint(const vk::raii::Context& context);

/// An instance of the system's drivers, or of the bundled one if those have no device.
/// @param wanted extensions besides the engine's own
/// @throws Error without a loader or driver, if an extension is missing, or if validation is requested and not
/// installed
/// @param headset  if not null, makes the instance, of the system's drivers
vk::raii::Instance makeInstance(const vk::raii::Context& context, bool validate, InstanceExtensions& found,
                                const std::vector<std::string>& wanted = {}, const HeadsetSource* headset = nullptr);

/// A device's extensions, valid until the thread's next call.
const std::vector<vk::ExtensionProperties>& listExtensions(const vk::raii::PhysicalDevice& device);

/// Collects validation messages of warning severity and above while the messenger lives.
vk::raii::DebugUtilsMessengerEXT makeMessenger(const vk::raii::Instance& instance, ValidationLog& messages);

/// The device with this number or part of a name; empty: discrete, integrated, virtual, then software. @throws Error
/// that lists the devices
vk::raii::PhysicalDevice pickDevice(const vk::raii::Instance& instance, const std::string& wanted);

}  // namespace nacre::gpu
