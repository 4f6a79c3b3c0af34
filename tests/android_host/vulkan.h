#pragma once
// What stands for Android's libvulkan.so: the machine's own loader, with VK_KHR_android_surface made of
// VK_EXT_headless_surface. A window says its size and turn as Android's do, and what is presented is read back.

#include <functional>

namespace nacre::test {

/// What happens on the app's thread while it waits for the next image of a window, until it has it; empty: nothing.
void whileImagesAreAwaited(std::function<void()> happens);

/// Waits for fences so far; those that there had been at the latest submission.
int fenceWaits();
int fenceWaitsOfSubmission();

/// No device from now on, as on a machine without a driver.
void setVulkanBroken(bool broken);

/// Whether the app has asked for the validation layer.
bool validationAsked();

/// So many devices, one after the other, are lost when the next frame of a window is asked for.
void loseDevices(int count);

/// What happens on the app's thread before a device is made; empty: nothing.
void whileDevicesAreMade(std::function<void()> happens);

/// Devices that were made since the process began.
int devicesMade();

/// Frames that are refused as out of date before the next one is taken.
void refuseFrames(int count);

}  // namespace nacre::test
