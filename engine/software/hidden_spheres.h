#pragma once
// Culls spheres hidden behind others of the same picture.

#include <cstdint>
#include <vector>

#include "engine/passes/placed_copies.h"
#include "engine/software/coverage.h"
#include "engine/software/software.h"
#include "engine/software/tile_view.h"

namespace nacre::passes {

/// Visits spheres from near to far, by chunks. A sphere is dropped if earlier ones certainly cover it: pictures stay
/// identical to the bit. Several threads take one band of rows each. Keeps its memory between frames, so that later
/// frames allocate only the threads.
class NearFirstSpheres final : public HiddenSpheres {
public:
    void drop(SceneView& seen, const Representation& representation, const Chunks& chunks, const View& view,
              graph::Extent image, bool centers) override;

private:
    /// Spheres of one chunk in one copy.
    struct Some {
        float near = 0;      // Z of the nearest point of their bounding sphere
        float x = 0, y = 0;  // centre of the bounding sphere's outline, pixels
        float reach = 0;     // half its width, pixels
        std::uint32_t copy = 0, first = 0, count = 0;
        std::uint32_t shown = 0;  // one bit per sphere
    };
    static_assert(Chunk::kPrimitives == 32);
    void list(const PlacedCopies& placed, const Chunks& chunks, const TileView& view);
    struct Scenery {
        const TileView& view;
        const std::vector<Sphere>& spheres;
        const PlacedCopies& copies;
    };
    struct Shown {
        std::uint32_t some, spheres;  // index of the chunk, and one bit per sphere
    };
    bool hides(const Some& some, RowBand part);
    std::uint32_t findShown(const Some& some, std::uint32_t asked, const Scenery& scenery, RowBand part, bool covers);
    void look(const Scenery& scenery, std::size_t part);

    Coverage coverage_;
    std::vector<Some> all_;
    std::vector<std::uint32_t> begins_, order_, inRow_;
    std::vector<RowBand> parts_;
    std::vector<std::vector<Shown>> shown_;  // per thread
};

}  // namespace nacre::passes
