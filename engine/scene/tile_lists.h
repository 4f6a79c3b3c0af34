#pragma once
// Which primitives may show in which part of the picture, in the order of their nearest depth: what the `tiles` path
// draws from. Conservative: a list may name a primitive that does not show, and never lacks one that does.

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "engine/scene/front_spheres.h"
#include "engine/scene/front_triangles.h"
#include "engine/scene/representation.h"
#include "engine/scene/tile_view.h"

namespace nacre {

/// All that a view is asked about.
struct TileScenery {
    std::span<const Sphere> spheres;
    std::span<const TileCall> sphereCalls;
    std::span<const Cylinder> cylinders;
    std::span<const TileCall> cylinderCalls;
    std::span<const Cylinder> wires = {};  ///< numbered on from the cylinders
    std::span<const Triangle> triangles = {};
    std::span<const MeshVertex> vertices = {};
    std::span<const TileCall> triangleCalls = {};
    std::span<const Triangle> coarseTriangles = {};  ///< numbered on from the others; no call has some of both
    std::span<const MeshRun> meshes = {};            ///< may be left out
    /// About the spheres, if the host draws them, so that few stand in lists: of views that FrontSpheres can tell of,
    /// without triangles. Null: all do.
    const SphereBoxes* boxes = nullptr;

    /// Those of a call.
    std::span<const Triangle> trianglesOf(const TileCall& call) const {
        if (call.first < triangles.size()) return triangles.subspan(call.first, call.count);
        return coarseTriangles.subspan(call.first - triangles.size(), call.count);
    }
};

/// Where pixels are asked at their centres alone, most triangles stand in no list: the host knows for nearly each pixel
/// which of them is the nearest. So it is with spheres, where they have boxes.
///
/// Bins of `kBinPixels` a side, row by row from the top left, each with its list, and the tiles of those bins whose
/// list is not empty or that begin with triangles. Kept from frame to frame, it allocates nothing once it has seen the
/// largest.
class TileLists {
public:
    static constexpr std::uint32_t kTilePixels = 8;
    static constexpr std::uint32_t kTilesInBin = 2;
    static constexpr std::uint32_t kBinPixels = kTilePixels * kTilesInBin;
    static constexpr std::uint32_t kDepthSteps = 2048;  ///< that the order of a list tells apart

    /// Pixels of a picture's bins together, whatever they show.
    static constexpr std::uint64_t pixelsOfBins(std::uint32_t width, std::uint32_t height) {
        const auto bins = [](std::uint32_t pixels) { return (std::uint64_t{pixels} + kBinPixels - 1) / kBinPixels; };
        return bins(width) * bins(height) * kBinPixels * kBinPixels;
    }

    /// Neighbouring bins of a row that are not empty; `end` is one past.
    struct Span {
        std::uint16_t x, y, endX, endY;
    };
    struct Tile {
        std::uint16_t x, y;
    };

    /// Sorts and counts; offsets(), tiles() and spans() are good until the next call.
    void build(const TileView& view, const TileScenery& scenery);

    std::uint32_t across() const { return across_; }
    std::uint32_t down() const { return down_; }
    /// Where each bin's list begins, and where the last one ends.
    std::span<const std::uint32_t> offsets() const { return offsets_; }
    std::span<const Tile> tiles() const { return tiles_; }  ///< in the order to draw them, a bin's one after another
    std::span<const Span> spans() const { return spans_; }
    /// Whether anything may show in a bin, counted row by row.
    bool holds(std::size_t bin) const { return offsets_[bin] != offsets_[bin + 1] || (seeded_ && seeds_[bin]); }
    /// Whether pixels may begin with a primitive: then with the one that writeSeeds() says.
    bool seeded() const { return seeded_; }
    /// Numbers of the nearest triangles, or spheres, of some pixels of a row, 0: none that is certain.
    void writeSeeds(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const {
        if (drawsSpheres_)
            frontSpheres_.write(x, y, count, to);
        else
            front_.write(x, y, count, to);
    }
    /// Of spheres that the host has drawn how many may show. None: all that it was given.
    std::optional<std::size_t> shownSpheres() const {
        return drawsSpheres_ ? std::optional(frontSpheres_.shown()) : std::nullopt;
    }
    std::size_t kept() const { return kept_.size(); }  ///< primitives in any list
    std::size_t keptSpheres() const { return keptSpheres_; }
    std::size_t entries() const { return offsets_.empty() ? 0 : offsets_.back(); }
    std::uint32_t longest() const { return longest_; }  ///< entries of a list
    /// What a device needs of it, in words: tiles (x | y << 16); where the bins' lists begin, and where the last ends;
    /// a primitive's number, 1; the lists. So the word before a list is a number of a primitive, and who goes through
    /// one that is empty may read that in place of its first.
    std::size_t words() const { return tiles_.size() + offsets_.size() + 1 + entries(); }
    void write(std::uint32_t* to);

private:
    /// Triangles of one mesh at one place: those of neighbouring calls together, since they share vertices.
    struct MeshPart {
        const glm::vec4* rows = nullptr;
        float step = 1;
        std::vector<TileCall> calls;
    };
    static std::vector<MeshPart> meshParts(const TileScenery& scenery);
    struct Kept {
        std::uint32_t number;
        std::uint16_t x, y, endX, endY;  // bins
        std::uint32_t step;              // of depth
    };

    void findSeeds();
    void add(const TileView& view, std::uint32_t number, glm::vec2 low, glm::vec2 high, float near,
             std::vector<Kept>& kept) const;
    void addSpheres(const TileView& view, std::span<const Sphere> spheres, const TileCall& call);
    void addCylinders(const TileView& view, const TileScenery& scenery, const TileCall& call);
    void placeCorners(const TileView& view, const TileScenery& scenery, const MeshPart& part);
    void addTriangle(const TileView& view, std::uint32_t number, const glm::vec3& a, const glm::vec3& b,
                     const glm::vec3& c, std::vector<Kept>& kept) const;
    void addDoubt(const TileView& view, const TileScenery& scenery, std::size_t index, bool placed,
                  std::vector<Kept>& kept) const;
    void addTriangles(const TileView& view, const TileScenery& scenery);
    void addFrontTriangles(const TileView& view, const TileScenery& scenery);
    void order();
    void count();
    void listTiles();

    std::uint32_t across_ = 0, down_ = 0, longest_ = 0;
    std::vector<Kept> kept_;
    std::vector<std::vector<Kept>> keptOfSlices_;
    std::size_t keptSpheres_ = 0;
    std::vector<std::uint32_t> order_, offsets_, cursors_;
    std::vector<Tile> tiles_, bins_;
    std::vector<Span> spans_;
    std::vector<glm::vec4> corners_;  // pixel and Z of each vertex, at the place of a call
    bool seeded_ = false, drawsSpheres_ = false;
    std::vector<std::uint8_t> seeds_;  // of each bin: some pixel has one
    std::vector<FrontTriangles::Run> runs_;
    FrontTriangles front_;
    FrontSpheres frontSpheres_;
};

}  // namespace nacre
