#pragma once
// Explains a lost device: the last submissions and the driver's own report.

#include <array>
#include <mutex>
#include <string>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

/// Names of the last submissions. Each is one line: its graphs with their passes. For any thread, of which each records
/// one submission at a time.
class SubmissionLog {
public:
    static constexpr std::size_t kKept = 3;

    /// Discards what was recorded and not submitted.
    void begin() { recording().clear(); }
    /// Adds a graph or pass that is being recorded: "screen: opaque prepass, depth encoding, impostor colour".
    void record(const std::string& work) {
        if (!recording().empty()) recording() += "; ";
        recording() += work;
    }
    void submitted();
    /// Newest first; empty if there was none.
    std::string text() const;

private:
    static std::string& recording();

    mutable std::mutex turn_;
    std::array<std::string, kKept> submitted_;  // newest first; empty: none
};

/// Whether the driver can explain a loss (VK_EXT_device_fault).
bool tellsOfFaults(const vk::raii::PhysicalDevice& device);

/// The driver's report of a loss as one line; empty if there is none. The device must have the extension enabled.
std::string faultText(const vk::raii::Device& device);

/// Replaces line breaks and other control characters (drivers' messages contain them) by spaces.
std::string inOneLine(std::string text);

}  // namespace nacre::gpu
