#pragma once
// Ends a frame in the image of its picture, on the device.

#include <optional>
#include <vector>

#include "engine/passes/full_screen.h"
#include "engine/results.h"
#include "engine/software/software.h"

namespace nacre::passes {

/// Which pixels of the picture a frame draws.
struct ResolvePlace {
    PictureRect rect;                  ///< in the picture
    std::int32_t x = 0, y = 0;         ///< of the same pixels in the frame, in pixels of the picture
    std::vector<PictureRect> parts{};  ///< in the picture, what is drawn of that; none: all
};

struct Resolving {
    std::uint32_t samples = 1;  ///< n: n x n pixels of the frame are one of the picture
    bool coded = false;         ///< both hold sRGB-coded colour that no format decodes
    bool masked = false;        ///< replaces only some pixels
};

/// Input of the resolve.
struct Resolved {
    vk::ImageView image;                ///< the frame's colour
    const TileFrame* tiles = nullptr;   ///< instead, if it is a buffer's words
    std::optional<vk::ImageView> mask;  ///< as large as the picture: 0 where pixels stay
};

void resolve(gpu::PassContext& context, const Resolving& how, const ResolvePlace& place, const Resolved& what);

}  // namespace nacre::passes
