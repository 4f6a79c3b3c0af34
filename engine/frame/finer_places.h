#pragma once
// Places where a picture with one sample per pixel needs more.

#include <cstdint>
#include <vector>

#include "engine/results.h"
#include "engine/scene/tile_view.h"

namespace nacre {

/// The pixels whose colour differs visibly from that of a neighbour.
class FinerPlaces {
public:
    FinerPlaces() = default;
    /// @param seen  linear, premultiplied, without a background
    explicit FinerPlaces(const Picture& seen);

    bool finer(std::uint32_t x, std::uint32_t y) const { return pixels_[std::size_t{y} * across_ + x] != 0; }
    /// The smallest rectangle that contains all finer pixels of a part. Its position relative to the part is a multiple
    /// of PictureRect::kStep. @returns an empty one if there are none
    PictureRect boundsIn(const PictureRect& part) const;
    /// The mask of a frame with RenderSettings::kBlockSamples x kBlockSamples samples per pixel.
    /// @param shown  part of the picture in the frame
    /// @param wanted  the frame's wanted part
    TileMask tilesOf(const PictureRect& shown, const PictureRect& wanted) const;

private:
    std::uint32_t across_ = 0;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace nacre
