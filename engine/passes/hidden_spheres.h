#pragma once
// Spheres that lie behind others of the same picture.

#include <cstdint>
#include <vector>

#include "engine/passes/placed_copies.h"
#include "engine/scene/coverage.h"

namespace nacre::passes {

/// Goes through spheres from near to far, by chunks: one that those before certainly cover shows in no pixel. Pictures
/// are the same to the bit. Kept from frame to frame, it allocates nothing once it has seen the most.
class HiddenSpheres {
public:
    /// Takes them out of the calls, which get many. @param radiusPixels  mean radius of the spheres in the picture
    void drop(PlacedCopies& placed, const Representation& representation, const Chunks& chunks, const TileView& view,
              double radiusPixels);

private:
    /// Spheres of one chunk at one place.
    struct Some {
        float near = 0;  // Z of the nearest point of a ball about them
        std::uint32_t copy = 0, first = 0, count = 0;
        std::uint32_t shown = 0;  // a bit each
    };
    static_assert(Chunk::kPrimitives == 32);
    void list(const PlacedCopies& placed, const Chunks& chunks, const TileView& view);
    void order(const TileView& view);
    void look(Some& some, const glm::vec4* rows, const Representation& representation, const TileView& view);

    Coverage coverage_;
    std::vector<Some> all_;
    std::vector<std::uint32_t> order_;
};

}  // namespace nacre::passes
