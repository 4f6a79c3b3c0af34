#pragma once
// RenderDoc's in-application API: one frame becomes a file that RenderDoc opens.

#include <string>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

class CaptureHook {
public:
    CaptureHook() = default;
    CaptureHook(const CaptureHook&) = delete;
    /// Gives up a capture that was begun and not ended.
    ~CaptureHook();

    /// Whether this program was built with RenderDoc's header.
    static bool built();

    /// Finds RenderDoc: the one that started this program, else, if `wanted`, the installed one. To be called before
    /// the instance is made, which then gets RenderDoc's layer. @throws Error if it is wanted and not there
    void load(bool wanted);
    /// @throws Error if Vulkan does not know RenderDoc's layer
    static void checkLayer(const vk::raii::Context& context);

    bool loaded() const { return api_ != nullptr; }
    /// RenderDoc started this program, and keeps its captures where it wants them.
    bool launched() const { return launched_; }

    /// Everything that the instance's device is given to do from here on belongs to the capture.
    /// @param stem of the file's name; empty: as RenderDoc likes. @throws Error if RenderDoc is not loaded
    void begin(vk::Instance instance, const std::string& stem);
    /// @returns the file that RenderDoc wrote. @throws Error if it wrote none
    std::string end();

private:
    void* api_ = nullptr;
    [[maybe_unused]] void* instance_ = nullptr;  ///< as RenderDoc knows it, while a capture goes on
    bool launched_ = false;
};

}  // namespace nacre::gpu
