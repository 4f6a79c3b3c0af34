#pragma once
// What is known when a device is lost: the work that was handed to it last, and the driver's own account.

#include <array>
#include <string>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

/// Names of what was submitted last. A submission is one line: the graphs recorded into it, with their passes.
class SubmissionLog {
public:
    static constexpr std::size_t kKept = 3;

    /// Forgets what was recorded and not submitted.
    void begin() { recording_.clear(); }
    /// A graph or pass is being recorded: "screen: opaque prepass, depth encoding, impostor colour".
    void record(const std::string& work) {
        if (!recording_.empty()) recording_ += "; ";
        recording_ += work;
    }
    void submitted();
    /// Newest first; empty if there was none.
    std::string text() const;

private:
    std::string recording_;
    std::array<std::string, kKept> submitted_;  // newest first; empty: there was none
};

/// Whether the driver tells what it knows of a loss (VK_EXT_device_fault).
bool tellsOfFaults(const vk::raii::PhysicalDevice& device);

/// The driver's account of a loss as one line; empty if it gives none. For a device with the extension enabled.
std::string faultText(const vk::raii::Device& device);

/// Line breaks and other control characters, which drivers put into their words, as spaces.
std::string inOneLine(std::string text);

}  // namespace nacre::gpu
