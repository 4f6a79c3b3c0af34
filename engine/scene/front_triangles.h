#pragma once
// Which triangles may be the nearest at the centre of a pixel: of a mesh whose triangles are as small as pixels, few.

#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "engine/scene/mesh_streams.h"
#include "engine/scene/triangle_shapes.h"

namespace nacre {

/// Kept from frame to frame, it allocates nothing once it has seen the largest.
class FrontTriangles {
public:
    /// Triangles that stand together in a stream, at one place.
    struct Run {
        std::span<const Triangle> triangles;
        const glm::vec4* rows = nullptr;  ///< three: into view space
        std::uint32_t number = 0;         ///< of the first primitive, not 0
    };

    FrontTriangles();
    ~FrontTriangles();

    /// Forgets what was drawn. Pixels are asked at their centres alone, and triangles have no lines about them.
    void begin(const TileView& view);
    /// Draws triangles by several threads if they are many.
    /// @param corners  of all vertices at the place of the runs: pixel and Z
    void draw(std::span<const Run> runs, std::span<const glm::vec4> corners);
    /// Finds for each pixel the triangle that certainly is the nearest of all that were drawn, whatever a shader
    /// rounds, but for doubtful ones.
    void end();

    /// Those that may be seen at some pixel for which they are not the certain ones.
    std::size_t doubts() const { return doubts_.size(); }
    /// @param number  becomes the triangle's
    const Triangle& doubt(std::size_t index, const glm::vec4*& rows, std::uint32_t& number) const;

    /// Whether a rectangle of pixels, to one past its end, has any that are certain.
    bool isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const;
    /// Numbers of the certain ones of some pixels of a row, 0 where there is none; beyond the picture, too.
    void write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const;

private:
    class Layer;
    /// What is looked at together. Triangles are counted by groups, as if all were full.
    struct Group {
        const Triangle* triangles = nullptr;
        std::uint32_t count = 0;
        const glm::vec4* rows = nullptr;
        std::uint32_t number = 0;
    };
    Layer& layer(std::size_t number);
    std::uint32_t numberOf(std::uint32_t index) const;

    TriangleLens lens_;
    std::vector<std::unique_ptr<Layer>> layers_;  // a thread's each
    std::size_t used_ = 0;                        // of them
    std::vector<Group> groups_;
    std::vector<std::uint32_t> doubts_;
    std::vector<std::vector<std::uint32_t>> doubtsOfSlices_;
};

}  // namespace nacre
