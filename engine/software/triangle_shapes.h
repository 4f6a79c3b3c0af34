#pragma once
// Triangles on the screen, with bounds for a shader's rounding. One thread draws them into a band of rows, with as many
// lanes as the processor has.

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "engine/scene/build/mesh_streams.h"
#include "engine/software/tile_view.h"

namespace nacre {

/// The camera for triangles. Depth keys are larger for nearer depths, and linear on the screen.
struct TriangleLens {
    std::uint32_t width = 0, height = 0;
    bool perspective = false;
    bool frontsOnly = false;                // triangles that certainly face away contain no centre
    float axisX = 0, axisY = 0, error = 0;  // pixels
    float errorOfZ = 0;
    bool clips = false;
    float clipNear = 0, clipFar = 0;  // Z

    TriangleLens() = default;
    explicit TriangleLens(const TileView& view);
    float depthKey(float Z) const { return perspective ? 1 / Z : -Z; }
    float errorOfKey(float key) const { return errorOfZ * (perspective ? key * key : 1.0f); }
};

/// From a copy's coordinates to the picture: pixel and Z.
struct CornerPlace {
    glm::vec4 x{}, y{}, z{};
    float axisX = 0, axisY = 0, origin = 0;
    bool perspective = false;

    CornerPlace(const TileView& view, const glm::vec4* rows);
    glm::vec4 operator()(const glm::vec3& p) const;
};

/// Triangles as planes over the screen: whether a triangle contains a pixel's centre, and its depth there. Each has an
/// error bound for rounding, of the shader and of the planes themselves.
struct TriangleShapes {
    static constexpr std::uint32_t kMost = 32;
    template <typename T>
    using Row = T[kMost];

    Row<float> nearest;                          ///< Z; kNowhere if it is invisible because it faces away
    Row<std::int32_t> left, right, top, bottom;  ///< range of pixels whose centres it may contain; right and bottom are
                                                 ///< exclusive
    static constexpr float kNowhere = 3.402823466e+38f;

    // For the triangles that are drawn:
    /// A linear function on the screen: value at the centre of pixel (`left`, `top`), and change per pixel.
    struct Plane {
        Row<float> start, right, down;
    };
    Plane edges[3];               ///< negative: certainly outside
    Row<float> inside[3];         ///< edges above these: certainly inside; infinite for splinters
    Plane key;                    ///< for a splinter: its maximum, as a constant
    Row<float> error;             ///< of a key
    std::uint32_t splinters = 0;  ///< a bit for each that is too narrow for any certainty
};

/// Rows of a picture for one thread: for each pixel, the nearest triangle that certainly contains its centre.
struct TriangleBand {
    static constexpr std::uint32_t kRoom = 16;  ///< pixels that are read beyond the end of a row
    static constexpr std::uint32_t kNone = 0xffffffffu;

    const TriangleLens* lens = nullptr;
    std::int32_t first = 0, end = 0;  ///< rows
    std::size_t pitch = 0;
    float *behind = nullptr, *before = nullptr;  ///< bounds of the key of each pixel's triangle
    std::uint32_t* index = nullptr;              ///< of the triangle
    std::uint8_t* rows = nullptr;                ///< rows that are not empty
    std::vector<std::uint32_t>* ambiguous = nullptr;

    void beginRow(std::int32_t y) const;
    /// Notes that a triangle may be nearer than a pixel's.
    void doubt(std::uint32_t triangle) const;
    /// Draws a triangle that may contain a centre. @param key  its largest possible key there
    /// @param certain  whether it certainly contains the centre
    void hold(const TriangleShapes& shapes, std::uint32_t i, std::uint32_t triangle, std::size_t at, float key,
              bool certain) const;

private:
    void meet(std::size_t at, float ofBehind, float ofBefore, std::uint32_t triangle) const;
};

/// Draws at most TriangleShapes::kMost triangles. @param shapes  receives their planes and bounds
/// @param corners  of all vertices: pixel and Z
/// @param index  of the first
using DrawTriangles = void (*)(const TriangleBand& band, TriangleShapes& shapes, const Triangle* triangles,
                               std::uint32_t count, const glm::vec4* corners, std::uint32_t index);

/// Places vertices in the picture. @param count  a multiple of 16
using PlaceCorners = void (*)(const CornerPlace& place, const MeshVertex* vertices, std::size_t count, float step,
                              glm::vec4* to);

struct TriangleLanes {
    std::uint32_t lanes = 0;
    DrawTriangles draw = nullptr;
    PlaceCorners place = nullptr;
};

/// Lane counts that this processor supports, ascending: 4, then 8.
std::span<const TriangleLanes> triangleLanes();

}  // namespace nacre
