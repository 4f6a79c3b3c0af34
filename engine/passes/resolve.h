#pragma once
// Resolves a frame into the image of its picture, on the device.

#include <optional>
#include <vector>

#include "engine/passes/full_screen.h"
#include "engine/passes/tile_frame.h"
#include "engine/results.h"

namespace nacre::passes {

/// The pixels of the picture that a frame draws.
struct ResolvePlace {
    PictureRect rect;                  ///< in the picture
    std::int32_t x = 0, y = 0;         ///< of the same pixels in the frame, in pixels of the picture
    std::vector<PictureRect> parts{};  ///< in the picture, the drawn parts of `rect`; none: all of it
};

struct Resolving {
    std::uint32_t samples = 1;  ///< n: n x n pixels of the frame form one of the picture
    bool coded = false;         ///< frame and picture hold sRGB-coded colour that no format decodes
    bool masked = false;        ///< replaces only some pixels
};

/// Input of the resolve.
struct Resolved {
    vk::ImageView image;                ///< the frame's colour
    const TileFrame* tiles = nullptr;   ///< instead of `image`, if the colour is in a buffer's words
    std::optional<vk::ImageView> mask;  ///< as large as the picture: 0 where pixels stay
};

void resolve(gpu::PassContext& context, const Resolving& how, const ResolvePlace& place, const Resolved& what);

}  // namespace nacre::passes
