#pragma once
// At most 255 colours that stand for those of some pictures, and which of them a pixel takes.

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace nacre::app {

using Rgb = std::array<std::uint8_t, 3>;

/// Counts colours, then divides them: the box of colours whose squared error is largest is cut in two where that leaves
/// least, again and again (Wan, Prusinkiewicz and Wong 1990), and the means settle by k-means. Pictures' commonest
/// colour, the background, is kept exactly.
class Palette {
public:
    static constexpr std::size_t kMost = 255;

    /// Colours of a picture, three bytes a pixel.
    void count(const std::vector<std::uint8_t>& rgb);
    /// To be called once, before colours() and place().
    void settle();
    const std::vector<Rgb>& colors() const { return colors_; }
    /// The nearest of the colours to a pixel at (x, y): of what lies between two, neighbouring pixels take one or the
    /// other in a fixed pattern, so that shades do not show as bands, and what stands still does not flicker.
    std::uint8_t place(const std::uint8_t* rgb, std::uint32_t x, std::uint32_t y);

private:
    std::uint8_t nearest(int r, int g, int b);

    std::unordered_map<std::uint32_t, std::uint64_t> counts_;
    std::vector<Rgb> colors_;
    std::unordered_map<std::uint32_t, std::uint8_t> known_;
    std::unordered_map<std::uint32_t, std::uint8_t> exact_;
};

}  // namespace nacre::app
