#pragma once
// Triangles on the screen, with bounds for a shader's rounding.

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>

#include "engine/scene/lanes.h"
#include "engine/scene/mesh_streams.h"
#include "engine/scene/tile_view.h"

namespace nacre {

/// The camera for triangles. Depth keys are larger for nearer depths, and linear on the screen.
struct TriangleLens {
    std::uint32_t width = 0, height = 0;
    bool perspective = false;
    bool frontsOnly = false;                // those that certainly turn away hold no centre
    float axisX = 0, axisY = 0, error = 0;  // pixels
    float errorOfZ = 0;
    bool clips = false;
    float clipNear = 0, clipFar = 0;  // Z

    TriangleLens() = default;
    explicit TriangleLens(const TileView& view);
    float keyOf(float Z) const { return perspective ? 1 / Z : -Z; }
    /// Pixels that a corner may be off. @param off  its distance from the axis, pixels
    Lanes rounded(Lanes off) const { return error + 1e-6f * off; }
    float errorOfKey(float key) const { return errorOfZ * (perspective ? key * key : 1.0f); }
};

/// Triangles as planes over the screen: whether a triangle contains a pixel's centre, and its depth there. Each has an
/// error bound for rounding, of the shader and of the planes themselves.
class TriangleShapes {
public:
    static constexpr std::uint32_t kMost = 32;

    /// Projects triangles. @param corners  of all vertices: pixel and Z
    void place(const TriangleLens& lens, const Triangle* triangles, std::uint32_t count, const glm::vec4* corners);

    template <typename T>
    using Row = std::array<T, kMost>;
    Row<float> nearest;                          ///< Z
    Row<std::int32_t> left, right, top, bottom;  ///< range of pixels whose centres it may contain; right and bottom are
                                                 ///< exclusive
    Row<std::int32_t> turnedAway;
    bool holdsCenter(std::uint32_t i) const { return left[i] < right[i] && top[i] < bottom[i]; }

    /// Bounds of four triangles.
    struct Box {
        std::int32_t left, right, top, bottom;
        float nearest;
        std::uint32_t away;  ///< a bit for each triangle that is invisible, since it turns away
    };
    std::array<Box, kMost / kLanes> boxes;

    /// The planes of four triangles, starting at a multiple of four. Small ones may turn out to contain no centre.
    void findPlanes(const TriangleLens& lens, std::uint32_t first);

    /// A linear function on the screen: value at the centre of pixel (`left`, `top`), and change per pixel.
    struct Plane {
        Row<float> start, right, down;
    };
    Plane edges[3];              ///< negative: certainly outside
    Row<float> inside[3];        ///< edges above these: certainly inside; infinite for splinters
    Plane key;                   ///< for a splinter: its maximum, as a constant
    Row<float> error;            ///< of a key
    Row<std::int32_t> splinter;  ///< so narrow that nothing about it is certain

private:
    void placeFour(const TriangleLens& lens, LanePoints a, LanePoints b, LanePoints c, std::uint32_t first);

    Row<float> x_[3], y_[3], z_[3];  // of the corners, counter-clockwise
    Row<float> area_;                // twice the area
};

}  // namespace nacre
