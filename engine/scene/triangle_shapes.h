#pragma once
// What triangles look like in a picture, and how far a shader's rounding may take that.

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>

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

/// Triangles in the picture, counter-clockwise.
class TriangleShapes {
public:
    static constexpr std::uint32_t kMost = 32;

    /// @param corners  of all vertices: pixel and Z
    void place(const TriangleLens& lens, const Triangle* triangles, std::uint32_t count, const glm::vec4* corners);

    template <typename T>
    using Row = std::array<T, kMost>;
    Row<float> x[3], y[3], z[3];                 ///< of the corners: pixels, Z
    Row<float> area;                             ///< twice
    Row<float> nearest;                          ///< Z
    Row<std::int32_t> left, right, top, bottom;  ///< pixels whose centres it may hold; right and bottom are one past
    Row<std::int32_t> turnedAway;

    bool holdsCenter(std::uint32_t i) const { return left[i] < right[i] && top[i] < bottom[i]; }
};

/// One of them, and what is certain of it.
struct TriangleBounds {
    float key[3];   ///< of the corners
    float room[3];  ///< of an edge function, on the edge across from a corner: what rounding does to it
    float perArea;  ///< 1 / (twice its area)
    float error;    ///< of a key within it
    bool splinter;  ///< so narrow that nothing about it is certain

    TriangleBounds(const TriangleLens& lens, const TriangleShapes& shapes, std::uint32_t i);
};

}  // namespace nacre
