#pragma once
// Finds the few triangles of a fine mesh that may be nearest at a pixel's centre.

#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "engine/scene/mesh_streams.h"
#include "engine/scene/triangle_shapes.h"

namespace nacre {

/// Keeps its memory between frames.
class FrontTriangles {
public:
    /// Consecutive triangles of a stream with one transform.
    struct Run {
        std::span<const Triangle> triangles;
        const glm::vec4* rows = nullptr;  ///< three: into view space
        std::uint32_t number = 0;         ///< of the first primitive, not 0
    };

    FrontTriangles();
    ~FrontTriangles();

    /// Clears. Triangles have no outlines. Unless the view draws edges, pixels are sampled at their centres only.
    void begin(const TileView& view);
    /// Draws triangles, by several threads if there are many.
    /// @param corners  of all vertices, transformed for the runs: pixel and Z
    void draw(std::span<const Run> runs, std::span<const glm::vec4> corners);
    /// Finds per pixel the triangle that is certainly nearest, whatever a shader's rounding; doubtful ones are listed.
    /// Where a view draws edges, those are all that are not behind what the centres around them show.
    void end();

    /// Number of further triangles that may be visible at some pixel, or at one of its samples.
    std::size_t doubts() const { return doubts_.size(); }
    /// @param number  receives the triangle's number
    const Triangle& doubt(std::size_t index, const glm::vec4*& rows, std::uint32_t& number) const;

    /// Whether a rectangle of pixels has any certain triangle. Ends are exclusive.
    bool isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const;
    /// Numbers of the certain triangles for some pixels of a row, 0: none; 0 beyond the picture as well.
    void write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const;

private:
    class Layer;
    /// Triangles processed together. Counted by groups, as if all were full.
    struct Group {
        const Triangle* triangles = nullptr;
        std::uint32_t count = 0;
        const glm::vec4* rows = nullptr;
        std::uint32_t number = 0;
    };
    using Box = TriangleShapes::Box;
    using BoxesOfGroup = decltype(TriangleShapes::boxes);
    Layer& layer(std::size_t number);
    std::uint32_t numberOf(std::uint32_t index) const;
    void merge();
    void doubtUncovered();

    TriangleLens lens_;
    bool edges_ = false;
    std::vector<std::unique_ptr<Layer>> layers_;  // one per thread
    std::size_t used_ = 0;                        // of layers_
    std::vector<Group> groups_;
    std::vector<BoxesOfGroup> boxes_;  // of the groups, where edges are drawn
    std::vector<std::uint32_t> doubts_;
    std::vector<std::vector<std::uint32_t>> doubtsOfSlices_;
};

}  // namespace nacre
