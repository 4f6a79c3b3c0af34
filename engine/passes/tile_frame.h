#pragma once
// A frame of the `tiles` path, as other passes see it (engine/tiles).

#include <cstdint>
#include <span>

#include "engine/gpu/resources.h"
#include "engine/results.h"

namespace nacre {

/// Squares of pixels that have a list of primitives each.
struct TileBins {
    static constexpr std::uint32_t kPixels = 16;  ///< per side
    /// Neighbouring bins of a row; ends are exclusive.
    struct Span {
        std::uint16_t x, y, endX, endY;
    };
    static constexpr std::uint64_t count(std::uint32_t width, std::uint32_t height) {
        const auto bins = [](std::uint32_t side) { return (std::uint64_t{side} + kPixels - 1) / kPixels; };
        return bins(width) * bins(height);
    }
    /// Pixels of all bins of a picture.
    static constexpr std::uint64_t pixels(std::uint32_t width, std::uint32_t height) {
        return count(width, height) * kPixels * kPixels;
    }
};

}  // namespace nacre

namespace nacre::passes {

/// A frame's lists, on the device.
class TileFrame {
public:
    virtual ~TileFrame() = default;
    virtual std::uint32_t longestList() const = 0;  ///< entries
    /// Where the device makes the lists: rounds in which it draws the tiles.
    virtual std::uint32_t rounds() const = 0;
    virtual TileCounts counts() const = 0;
    virtual std::span<const TileBins::Span> spans() const = 0;  ///< bins that show anything
    /// Whether a bin may show a primitive that lies between pixel centres, where the host makes the lists.
    virtual bool showsSmall(std::uint32_t x, std::uint32_t y) const = 0;
    virtual float nearest() const = 0;            ///< Z of the nearest depth
    virtual float farthest() const = 0;           ///< Z of the farthest
    virtual std::uint32_t rowPixels() const = 0;  ///< pixels per row of the buffers
    /// What compute writes per pixel, row by row of all bins: TileResult. Empty where that is an image.
    virtual const gpu::Buffer& pixels() const = 0;
    virtual vk::BufferView pixelTexels() const = 0;  ///< pixels() as texels
    /// Where the device makes the lists: their entries in any order, and the lists.
    virtual const gpu::Buffer& entries() const = 0;
    virtual const gpu::Buffer& sortedEntries() const = 0;
    virtual const gpu::Buffer& edges() const = 0;  ///< numbers if pixels() are colours, else edge colours
    virtual const gpu::Buffer& edgePixels() const = 0;
};

}  // namespace nacre::passes
