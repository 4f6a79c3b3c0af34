#pragma once
// Spheres that lie behind others of the same picture.

#include <cstdint>
#include <vector>

#include "engine/passes/placed_copies.h"
#include "engine/scene/coverage.h"

namespace nacre::passes {

/// Goes through spheres from near to far, by chunks: one that those before certainly cover shows in no pixel. Pictures
/// are the same to the bit. Several threads take a part of the picture's rows each. Kept from frame to frame, it
/// allocates nothing but those threads once it has seen the most.
class HiddenSpheres {
public:
    /// Takes them out of the calls, which get many. @param radiusPixels  mean radius of the spheres in the picture
    void drop(PlacedCopies& placed, const Representation& representation, const Chunks& chunks, const TileView& view,
              double radiusPixels);

private:
    /// Spheres of one chunk at one place.
    struct Some {
        float near = 0;      // Z of the nearest point of a ball about them
        float x = 0, y = 0;  // pixel in the middle of what the ball covers
        float reach = 0;     // pixels about that
        std::uint32_t copy = 0, first = 0, count = 0;
        std::uint32_t shown = 0;  // a bit each
    };
    static_assert(Chunk::kPrimitives == 32);
    void list(const PlacedCopies& placed, const Chunks& chunks, const TileView& view);
    struct Scenery {
        const TileView& view;
        const std::vector<Sphere>& spheres;
        const PlacedCopies& copies;
    };
    struct Shown {
        std::uint32_t some, spheres;  // its place, and a bit each
    };
    bool hides(const Some& some, RowBand part);
    std::uint32_t shownOf(const Some& some, std::uint32_t asked, const Scenery& scenery, RowBand part, bool covers);
    void look(const Scenery& scenery, std::size_t part);

    Coverage coverage_;
    std::vector<Some> all_;
    std::vector<std::uint32_t> begins_, order_, inRow_;
    std::vector<RowBand> parts_;
    std::vector<std::vector<Shown>> shown_;  // of each
};

}  // namespace nacre::passes
