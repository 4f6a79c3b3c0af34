#pragma once
// Places where a picture with one sample per pixel needs more.

#include <cstdint>
#include <glm/vec4.hpp>
#include <utility>
#include <vector>

#include "engine/graph/graph.h"
#include "engine/passes/tile_mask.h"
#include "engine/results.h"
#include "engine/tiles/tiles.h"

namespace nacre {

/// Pixels whose colour differs visibly from a neighbour's, and the samples that they need. A pixel's error is that of
/// its coverage times the difference of the colours.
class FinerPlaces {
public:
    /// Samples per pixel side where colours differ a little and much.
    static constexpr std::uint32_t kFew = 2, kMany = 4;

    FinerPlaces() = default;
    /// @param seen  RGBA8, sRGB-coded, premultiplied
    FinerPlaces(const std::uint32_t* seen, std::uint32_t rowPixels, graph::Extent image);
    /// @param seen  four linear floats per pixel, premultiplied @param under  what is behind them
    FinerPlaces(const float* seen, graph::Extent image, const glm::vec4& under = {});

    /// Adds all pixels of a part, with many samples.
    void add(const PictureRect& part);
    /// Adds the eight pixels around each finer one.
    void grow();
    /// Gives all finer pixels many samples.
    void takeMany();

    static constexpr std::uint32_t kTogether = 4;
    /// Drops blurred pixels. @param sharp  one byte per kTogether x kTogether pixels, row by row; 0: blurred
    void keep(const std::vector<std::uint8_t>& sharp);
    /// Whether any pixel is left.
    bool any() const;

    /// A byte per pixel, row by row: the samples per side that it needs, less one.
    const std::vector<std::uint8_t>& bytes() const { return pixels_; }
    /// The smallest rectangle that contains all finer pixels of a part. Its position relative to the part is a multiple
    /// of PictureRect::kStep. @param n  of pixels with n x n samples only; 0: of all @returns an empty one if there are
    /// none
    PictureRect boundsIn(const PictureRect& part, std::uint32_t n = 0) const;
    /// Smallest rectangles per band of a part's rows, without empty ones: together much smaller than boundsIn().
    std::vector<PictureRect> bandsIn(const PictureRect& part) const;
    /// The mask of a frame with n x n samples per pixel, for pixels that need as many.
    /// @param shown  part of the picture in the frame
    /// @param wanted  the frame's wanted part
    TileMask findTiles(const PictureRect& shown, const PictureRect& wanted, std::uint32_t n) const;
    /// The edges of a frame with one sample per pixel, and the tiles that need them.
    std::pair<passes::EdgePlaces, TileMask> findEdges(const PictureRect& shown, const PictureRect& wanted) const;

private:
    bool finer(std::uint32_t x, std::uint32_t y) const { return pixels_[std::size_t{y} * across_ + x] != 0; }
    bool needs(std::uint32_t x, std::uint32_t y, std::uint32_t n) const {
        return pixels_[std::size_t{y} * across_ + x] == n - 1;
    }

    std::uint32_t across_ = 0;
    std::vector<std::uint8_t> pixels_;  // as bytes(): 0, 1 or 3, so that `or` gives the larger
};

}  // namespace nacre
