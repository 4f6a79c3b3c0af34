#pragma once
// A palette of at most 255 colours for some pictures, with ordered dithering.

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace nacre::app {

using Rgb = std::array<std::uint8_t, 3>;

/// Counts colours, then divides them: repeatedly splits the box of colours with the largest squared error where least
/// error remains (Wan, Prusinkiewicz and Wong 1990), and refines the means by k-means. The most common colour, the
/// background, is kept exactly.
class Palette {
public:
    static constexpr std::size_t kMost = 255;

    /// Counts a picture's colours, three bytes per pixel.
    void count(const std::vector<std::uint8_t>& rgb);
    /// Call once, before colours() and place().
    void settle();
    const std::vector<Rgb>& colors() const { return colors_; }
    /// The palette colour for a pixel at (x, y). Between two colours, neighbouring pixels alternate in a fixed pattern,
    /// so that shades show no bands, and still parts do not flicker.
    std::uint8_t place(const std::uint8_t* rgb, std::uint32_t x, std::uint32_t y);

private:
    std::uint8_t nearest(int r, int g, int b);

    std::unordered_map<std::uint32_t, std::uint64_t> counts_;
    std::vector<Rgb> colors_;
    std::unordered_map<std::uint32_t, std::uint8_t> known_;
    std::unordered_map<std::uint32_t, std::uint8_t> exact_;
};

}  // namespace nacre::app
