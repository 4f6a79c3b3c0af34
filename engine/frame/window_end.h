#pragma once
// The passes behind a scene's own that bring its frame onto a window. Those of a window at rest read their own pixel
// alone, so that colour and sum of samples may stay on the tile. Frames in motion are read as textures: whole and
// smaller ones share their pipelines.

#include <array>
#include <optional>

#include "engine/frame/frame.h"
#include "engine/passes/full_screen.h"

namespace nacre {

/// Format of sample sums: blendable on every device; sums sixteen samples within a quarter of an 8-bit step.
constexpr VkFormat kSumFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

/// What the passes record with; set before each recording.
struct WindowSamples {
    float share = 1;                             ///< weight of one sample of the shown sum
    std::array<passes::Resampling, 2> ofEyes{};  ///< into the sum
    std::size_t eye = 0;                         ///< of frames that draw one of them
};

struct WindowEnd {
    VkFormat format{};                       ///< of the window's images
    const WindowSamples* samples = nullptr;  ///< null: the frame is only planned
    graph::Work overlay{};

    /// Whether shaders code the colour, since the format does not.
    bool coded() const { return format == VK_FORMAT_B8G8R8A8_UNORM || format == VK_FORMAT_R8G8B8A8_UNORM; }
    /// Declares the end of a shape. The last target is the window.
    void declare(Frame& frame, const FrameShape& shape) const;
    /// The pass that brings a picture onto the window. @param count  n: n x n texels are a pixel; 0: any other ratio
    graph::Image addPicture(graph::Graph& frame, graph::Image picture, graph::Extent window, std::uint32_t count) const;
    /// The same for a sum of samples, which has the window's size.
    graph::Image addShownSum(graph::Graph& frame, graph::Image sum, graph::Extent window) const;
    /// The pass that adds a sample of each pixel to the sum; for each view one. @returns the sum, to be bound
    /// @param eye  whether the sample is of one eye or of both (WindowSamples::ofEyes), not of the whole window
    graph::Image addSum(graph::Graph& frame, graph::Image sample, graph::Extent window, bool first, bool eye = false,
                        std::uint32_t views = 1) const;

private:
    graph::Image addWindow(graph::Graph& frame, graph::Image picture, graph::Extent window, std::uint32_t count,
                           passes::NearestFrom from) const;
    void addOverlay(graph::Graph& frame, graph::Image& window, std::optional<graph::Image>& samples) const;
};

}  // namespace nacre
