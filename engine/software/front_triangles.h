#pragma once
// Finds the few triangles of a fine mesh that may be nearest at a pixel's centre.

#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "engine/lists/near_first.h"
#include "engine/scene/build/chunks.h"
#include "engine/scene/build/mesh_streams.h"
#include "engine/software/triangle_shapes.h"

namespace nacre {

/// Keeps its memory between frames.
class FrontTriangles {
public:
    /// Consecutive triangles of a stream with one transform.
    struct Run {
        std::span<const Triangle> triangles;
        const glm::vec4* rows = nullptr;     ///< three: into view space
        std::uint32_t number = 0;            ///< of the first primitive, not 0
        std::span<const Chunk> chunks = {};  ///< in which they lie; empty: unknown
        std::uint32_t first = 0;             ///< of the run's first triangle, in the first chunk
    };

    explicit FrontTriangles(const TriangleLanes& lanes);
    ~FrontTriangles();

    /// Clears. Triangles have no outlines. Unless the view draws edges, pixels are sampled at their centres only.
    void begin(const TileView& view);
    /// Draws triangles, by several threads if there are many.
    /// @param corners  of all vertices, transformed for the runs: pixel and Z
    void draw(std::span<const Run> runs, std::span<const glm::vec4> corners);
    /// Finds per pixel the triangle that is certainly nearest, whatever a shader's rounding; doubtful ones are listed.
    /// Where a view draws edges, these are all that the centres around them do not hide.
    void end();

    /// Number of further triangles that may be visible at some pixel, or at one of its samples.
    std::size_t ambiguous() const { return ambiguous_.size(); }
    /// @param number  receives the triangle's number
    const Triangle& doubt(std::size_t index, const glm::vec4*& rows, std::uint32_t& number) const;

    /// Whether a rectangle of pixels shows any certain triangle. Ends are exclusive.
    bool isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const;
    /// Numbers of the certain triangles for some pixels of a row; 0: none, or outside the picture.
    void write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const;

private:
    struct Picture;
    class Band;
    struct Box;
    /// Triangles processed together, within one chunk. Groups are counted as if all were full.
    struct Group {
        const Triangle* triangles = nullptr;
        std::uint32_t count = 0;
        const glm::vec4* rows = nullptr;
        const Chunk* ball = nullptr;  // null: unknown
    };
    /// Rows of pixels in which a group may be visible.
    struct Placed {
        float near = 0;  // Z
        std::uint32_t group = 0;
        std::int32_t top = 0, bottom = 0;  // equal: none
    };
    std::uint32_t triangleNumber(std::uint32_t index) const;
    void addGroups(const Run& run);
    Placed place(const Group& group, std::uint32_t number) const;
    void doubtUncovered(const Band& band);

    TriangleLanes lanes_;
    TileView view_;
    TriangleLens lens_;
    std::unique_ptr<Picture> picture_;
    std::vector<Band> bands_;  // one per thread
    std::vector<RowBand> rows_;
    std::vector<std::uint32_t> inRow_;
    std::vector<Group> groups_;
    std::vector<std::uint32_t> numbers_;  // of each group's first triangle
    std::vector<Placed> placed_, sorted_;
    std::vector<std::uint32_t> marks_;  // per group, a bit for each doubtful triangle
    std::vector<std::uint32_t> ambiguous_;
};

}  // namespace nacre
