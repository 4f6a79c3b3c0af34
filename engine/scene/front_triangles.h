#pragma once
// Which triangles may be the nearest at the centre of a pixel: of a mesh whose triangles are as small as pixels, few.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/scene/mesh_streams.h"

namespace nacre {

struct TileView;

/// Kept from frame to frame, it allocates nothing once it has seen the largest.
class FrontTriangles {
public:
    /// Forgets what was drawn. Pixels are asked at their centres alone, and triangles have no lines about them.
    void begin(const TileView& view);
    /// Draws triangles, counted on from what was drawn before.
    /// @param corners  of all vertices: pixel and Z
    void draw(std::span<const Triangle> triangles, std::span<const glm::vec3> corners);
    /// Finds those that no other certainly hides at each pixel that they may hold, whatever a shader rounds: it is as
    /// if the others were not there.
    void end();
    /// The first of these from one on, counted over all that was drawn; that many or more: there is none.
    std::size_t next(std::size_t index) const;

private:
    struct Pixel {
        float key, error;     // of the nearest triangle that certainly holds the centre: the larger, the nearer
        std::uint32_t index;  // its own
    };
    struct Shape;
    void drawShape(const Shape& shape, std::uint32_t index);
    void meet(Pixel& pixel, float key, float error, bool certain, std::uint32_t index);

    std::uint32_t width_ = 0, height_ = 0, drawn_ = 0;
    bool perspective_ = false;
    float axisX_ = 0, axisY_ = 0, error_ = 0;  // pixels
    float errorOfZ_ = 0;
    float clipNear_ = 0, clipFar_ = 0;  // Z
    std::vector<Pixel> pixels_;
    std::vector<bool> rows_;             // that hold anything
    std::vector<std::uint32_t> doubts_;  // triangles that may be nearer than those of the pixels
    std::vector<std::uint64_t> front_;
};

}  // namespace nacre
