#pragma once
// The last passes of a window's frame: they show the scene's colour in the window. At rest each reads only its own
// pixel, so that the colour and the sum of samples can stay on the tile. Frames in motion are read as textures, so that
// those of full and reduced size share their pipelines.

#include <array>
#include <optional>

#include "engine/frame/frame.h"
#include "engine/passes/full_screen.h"

namespace nacre {

/// Format of sample sums: blendable on every device. Sums sixteen samples within a quarter of an 8-bit step.
constexpr VkFormat kSumFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

/// Values of a frame's samples, set before each recording.
struct WindowSamples {
    float share = 1;                             ///< weight of one sample in the shown sum
    std::array<passes::Resampling, 2> ofEyes{};  ///< how each eye's sample is added to the sum
    std::size_t eye = 0;                         ///< which one a frame of a single eye draws
};

struct WindowEnd {
    VkFormat format{};                       ///< of the window's images
    const WindowSamples* samples = nullptr;  ///< null: the frame is only planned
    graph::Work overlay{};

    /// Whether shaders encode sRGB because the format does not.
    bool coded() const { return format == VK_FORMAT_B8G8R8A8_UNORM || format == VK_FORMAT_R8G8B8A8_UNORM; }
    /// Declares the last passes of a shape. The last target becomes the window.
    void declare(Frame& frame, const FrameShape& shape) const;
    /// Shows a picture in the window. @param count  n: a pixel is n x n texels; 0: any other ratio
    graph::Image addPicture(graph::Graph& frame, graph::Image picture, graph::Extent window, std::uint32_t count) const;
    /// Shows a sum of samples in the window; both have the same size.
    graph::Image addShownSum(graph::Graph& frame, graph::Image sum, graph::Extent window) const;
    /// Adds one sample per pixel to the sum, in one pass per view. @returns the sum, an image that the caller binds
    /// @param eye  whether the sample shows one or both eyes (WindowSamples::ofEyes) instead of the whole window
    graph::Image addSum(graph::Graph& frame, graph::Image sample, graph::Extent window, bool first, bool eye = false,
                        std::uint32_t views = 1) const;

private:
    graph::Image addWindow(graph::Graph& frame, graph::Image picture, graph::Extent window, std::uint32_t count,
                           passes::NearestFrom from) const;
    void addOverlay(graph::Graph& frame, graph::Image& window, std::optional<graph::Image>& samples) const;
};

}  // namespace nacre
