#pragma once
// Places where a picture with one sample per pixel needs more.

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/graph/graph.h"
#include "engine/passes/tile_mask.h"
#include "engine/results.h"
#include "engine/tiles/tiles.h"

namespace nacre {

/// Pixels whose colour differs visibly from a neighbour's.
class FinerPlaces {
public:
    FinerPlaces() = default;
    /// @param seen  RGBA8, premultiplied with sRGB-coded colour, without a background
    FinerPlaces(const std::uint32_t* seen, std::uint32_t rowPixels, graph::Extent image);
    /// @param seen  four linear floats per pixel, premultiplied
    FinerPlaces(const float* seen, graph::Extent image);

    /// Adds all pixels of a part.
    void add(const PictureRect& part);
    /// Adds the eight pixels around each finer one.
    void grow();

    static constexpr std::uint32_t kTogether = 4;
    /// Drops blurred pixels. @param sharp  one byte per kTogether x kTogether pixels, row by row; 0: blurred
    void keep(const std::vector<std::uint8_t>& sharp);
    /// Whether any pixel is left.
    bool any() const;

    /// A byte per pixel, row by row: 0 where one sample is enough.
    const std::vector<std::uint8_t>& bytes() const { return pixels_; }
    /// The smallest rectangle that contains all finer pixels of a part. Its position relative to the part is a multiple
    /// of PictureRect::kStep. @returns an empty one if there are none
    PictureRect boundsIn(const PictureRect& part) const;
    /// Smallest rectangles per band of a part's rows, without empty ones: together much smaller than boundsIn().
    std::vector<PictureRect> bandsIn(const PictureRect& part) const;
    /// The mask of a frame with RenderSettings::kBlockSamples x kBlockSamples samples per pixel.
    /// @param shown  part of the picture in the frame
    /// @param wanted  the frame's wanted part
    TileMask findTiles(const PictureRect& shown, const PictureRect& wanted) const;
    /// The edges of a frame with one sample per pixel, and the tiles that need them.
    std::pair<passes::EdgePlaces, TileMask> findEdges(const PictureRect& shown, const PictureRect& wanted) const;

private:
    bool finer(std::uint32_t x, std::uint32_t y) const { return pixels_[std::size_t{y} * across_ + x] != 0; }

    std::uint32_t across_ = 0;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace nacre
