#pragma once

#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "engine/device_options.h"
#include "engine/gpu/validation_log.h"

namespace nacre::gpu {

struct InstanceExtensions {
    bool debugUtils = false, portability = false;
    bool surfaceMaintenance = false;  ///< whether the window extensions asked for include it
};

/// How a headset's runtime makes objects gets at Vulkan.
HeadsetSource::EntryPoint entryPoint(const vk::raii::Context& context);

/// An instance of the system's drivers, or of the bundled one where those have no device.
/// @param wanted extensions besides the engine's own
/// @throws Error without a loader or driver, if an extension is missing, or if validation is asked for and not
/// installed
/// @param headset  not null: makes it of the system's drivers
vk::raii::Instance makeInstance(const vk::raii::Context& context, bool validate, InstanceExtensions& found,
                                const std::vector<std::string>& wanted = {}, const HeadsetSource* headset = nullptr);

/// A device's extensions, valid until the thread's next call.
const std::vector<vk::ExtensionProperties>& extensionsOf(const vk::raii::PhysicalDevice& device);

/// Collects validation messages of warning severity and above while the messenger lives.
vk::raii::DebugUtilsMessengerEXT makeMessenger(const vk::raii::Instance& instance, ValidationLog& messages);

/// The device with this number or part of a name; empty: discrete, integrated, virtual, then software. @throws Error
/// that lists the devices
vk::raii::PhysicalDevice pickDevice(const vk::raii::Instance& instance, const std::string& wanted);

}  // namespace nacre::gpu
