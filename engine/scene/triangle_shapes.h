#pragma once
// What triangles look like in a picture, and how far a shader's rounding may take that.

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>

#include "engine/scene/lanes.h"
#include "engine/scene/mesh_streams.h"
#include "engine/scene/tile_view.h"

namespace nacre {

/// How a view looks at triangles. The key of a depth is the larger, the nearer, and linear in the picture.
struct TriangleLens {
    std::uint32_t width = 0, height = 0;
    bool perspective = false;
    float axisX = 0, axisY = 0, error = 0;  // pixels
    float errorOfZ = 0;
    bool clips = false;
    float clipNear = 0, clipFar = 0;  // Z

    TriangleLens() = default;
    explicit TriangleLens(const TileView& view);
    float keyOf(float Z) const { return perspective ? 1 / Z : -Z; }
    float errorOfKey(float key) const { return errorOfZ * (perspective ? key * key : 1.0f); }
};

/// Triangles in the picture, as planes over it: whether one holds the centre of a pixel, and how near it is there. Each
/// is so far off at most as rounding, a shader's and that of the planes themselves, may take it.
class TriangleShapes {
public:
    static constexpr std::uint32_t kMost = 32;

    /// Where they are. @param corners  of all vertices: pixel and Z
    void place(const TriangleLens& lens, const Triangle* triangles, std::uint32_t count, const glm::vec4* corners);

    template <typename T>
    using Row = std::array<T, kMost>;
    Row<float> nearest;                          ///< Z
    Row<std::int32_t> left, right, top, bottom;  ///< pixels whose centres it may hold; right and bottom are one past
    Row<std::int32_t> turnedAway;
    bool holdsCenter(std::uint32_t i) const { return left[i] < right[i] && top[i] < bottom[i]; }

    /// Around four of them.
    struct Box {
        std::int32_t left, right, top, bottom;
        float nearest;
    };
    std::array<Box, kMost / kLanes> boxes;

    /// The planes of four of them, from a multiple of four on. If they are small they may turn out to hold no centre.
    void findPlanes(const TriangleLens& lens, std::uint32_t first);

    /// What is linear in the picture: at the centre of the pixel `left`, `top`, and how it changes by pixels from
    /// there.
    struct Plane {
        Row<float> start, right, down;
    };
    Plane edges[3];              ///< negative where a place certainly is outside
    Row<float> inside[3];        ///< where the edges are above these it certainly is inside; infinite for splinters
    Plane key;                   ///< of a splinter the largest that it may have, everywhere
    Row<float> error;            ///< of a key
    Row<std::int32_t> splinter;  ///< so narrow that nothing about it is certain

private:
    void placeFour(const TriangleLens& lens, LanePoints a, LanePoints b, LanePoints c, std::uint32_t first);

    Row<float> x_[3], y_[3], z_[3];  // of the corners, counter-clockwise
    Row<float> area_;                // twice
};

}  // namespace nacre
