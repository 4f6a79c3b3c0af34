#pragma once
// RenderDoc's in-application API: captures one frame into a file that RenderDoc opens.

#include <string>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

class CaptureHook {
public:
    CaptureHook() = default;
    CaptureHook(const CaptureHook&) = delete;
    /// Discards an unfinished capture.
    ~CaptureHook();

    /// Whether this program was built with RenderDoc's header.
    static bool built();

    /// Finds RenderDoc: the one that started this program, else, if `wanted`, the installed one. Call before the
    /// instance is made, which then gets RenderDoc's layer. @throws Error if it is wanted and not found
    void load(bool wanted);
    /// @throws Error if Vulkan does not know RenderDoc's layer
    static void checkLayer(const vk::raii::Context& context);

    bool loaded() const { return api_ != nullptr; }
    /// RenderDoc started this program and chooses where captures go.
    bool launched() const { return launched_; }

    /// Captures everything that the instance's device executes from here on. @param stem of the file's name; empty:
    /// RenderDoc's default. @throws Error if RenderDoc is not loaded
    void begin(vk::Instance instance, const std::string& stem);
    /// @returns the file that RenderDoc wrote. @throws Error if it wrote none
    std::string end();

private:
    void* api_ = nullptr;
    [[maybe_unused]] void* instance_ = nullptr;  ///< the instance as RenderDoc knows it, during a capture
    bool launched_ = false;
};

}  // namespace nacre::gpu
