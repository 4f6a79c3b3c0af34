#pragma once
// Arranges pictures of one size in rows from the top, with gaps between them.

#include <algorithm>
#include <array>
#include <cstdint>

#include "app/picture/description.h"
#include "engine/results.h"
#include "engine/srgb.h"

namespace nacre::app {

class PictureGrid {
public:
    /// @param gap  pixels @param ground  of the gaps: sRGB-coded, straight alpha
    PictureGrid(const Size& cell, std::size_t cells, std::size_t columns, std::uint32_t gap,
                const std::array<float, 4>& ground)
        : columns_(std::min(cells, columns)), right_(cell.width + gap), down_(cell.height + gap) {
        const std::size_t rows = (cells + columns_ - 1) / columns_;
        picture_.width = static_cast<std::uint32_t>(columns_ * right_ - gap);
        picture_.height = static_cast<std::uint32_t>(rows * down_ - gap);
        picture_.rgba.resize(std::size_t{4} * picture_.width * picture_.height);
        const auto& [r, g, b, a] = ground;
        const std::array<float, 4> color = {srgbToLinear(r) * a, srgbToLinear(g) * a, srgbToLinear(b) * a, a};
        for (std::size_t i = 0; i < picture_.rgba.size(); ++i) picture_.rgba[i] = color[i % 4];
    }

    void put(std::size_t index, const Picture& picture) {
        const std::size_t left = index % columns_ * right_, top = index / columns_ * down_;
        for (std::size_t y = 0; y < picture.height; ++y)
            std::copy_n(&picture.rgba[4 * y * picture.width], 4 * picture.width,
                        &picture_.rgba[4 * ((top + y) * picture_.width + left)]);
    }
    const Picture& picture() const { return picture_; }

private:
    std::size_t columns_, right_, down_;
    Picture picture_;
};

}  // namespace nacre::app
