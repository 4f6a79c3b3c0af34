#pragma once
// Between the layer's hooks and what steers them.

#include <optional>

#include "tests/fault_layer/faults.h"

namespace nacre::faults {

void readEnvironment();
/// What a call is to return instead of what it does; nothing: what it does. Counts it.
/// @param runsOut   may return VK_ERROR_OUT_OF_HOST_MEMORY  @param canBeLost may return VK_ERROR_DEVICE_LOST
std::optional<VkResult> verdict(const char* function, bool runsOut, bool canBeLost);
/// Objects that came or, below 0, went.
void made(const std::string& kind, std::int64_t count);
void newDevice();
bool offersFaultData();
bool hides(const std::string& extension);
VkExtent2D windowSize();
void heard(const char* message);
void instanceGone();

/// Waits until the device has done all work, so that a lost one truly has nothing in flight. The hooks have it.
void letFinish();

}  // namespace nacre::faults
