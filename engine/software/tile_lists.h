#pragma once
// Lists of the primitives that may be visible in each part of a picture, by nearest depth: input of the `tiles` path.
// Conservative: a list may contain an invisible primitive, but never lacks a visible one.

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "engine/scene/build/representation.h"
#include "engine/software/front_spheres.h"
#include "engine/software/front_triangles.h"
#include "engine/software/tile_view.h"
#include "engine/tiles/tile_set.h"

namespace nacre {

/// Everything that may be visible.
struct TileScenery {
    std::span<const Sphere> spheres;
    std::span<const TileCall> sphereCalls;
    std::span<const Cylinder> cylinders;
    std::span<const TileCall> cylinderCalls;
    std::span<const Cylinder> wires = {};  ///< numbered after the cylinders
    std::span<const Triangle> triangles = {};
    std::span<const MeshVertex> vertices = {};
    std::span<const TileCall> triangleCalls = {};
    std::span<const Triangle> coarseTriangles = {};  ///< numbered after the others; no call mixes both
    std::span<const MeshRun> meshes = {};            ///< optional
    /// Boxes of the spheres, if the host draws them, so that few enter lists. Only for views that FrontSpheres
    /// supports, without triangles. Null: all spheres enter lists.
    const SphereBoxes* boxes = nullptr;
    std::span<const Chunk> triangleChunks = {};  ///< optional

    /// The triangles of a call.
    std::span<const Triangle> callTriangles(const TileCall& call) const {
        if (call.first < triangles.size()) return triangles.subspan(call.first, call.count);
        return coarseTriangles.subspan(call.first - triangles.size(), call.count);
    }
    std::span<const Chunk> callChunks(const TileCall& call) const {
        if (triangleChunks.empty()) return {};
        return triangleChunks.subspan(call.first / Chunk::kPrimitives);
    }
};

/// Lists of a picture's primitives. Where pixels are sampled at their centres only, most triangles enter no list: the
/// host knows the nearest one of nearly every pixel. Spheres with boxes enter none: the host finds all of them. Where
/// edges are drawn, triangles enter unless all surrounding pixels hide them.
///
/// Tiles are those of bins with a non-empty list, or with initial primitives. Keeps its memory between frames.
class TileLists : public TileSet {
public:
    explicit TileLists(const TriangleLanes& lanes = triangleLanes().back()) : lanes_(lanes), front_(lanes) {}

    static constexpr std::uint32_t kDepthSteps = 2048;  ///< resolution of the order in a list (layout::kListSteps)

    /// Builds the lists; offsets(), tiles() and spans() are valid until the next call.
    void build(const TileView& view, const TileScenery& scenery);

    /// Begin of each bin's list, and the end of the last.
    std::span<const std::uint32_t> offsets() const { return offsets_; }
    /// Whether anything may be visible in a bin, counted row by row.
    bool holds(std::size_t bin) const {
        return drawsBin(bin) && (offsets_[bin] != offsets_[bin + 1] || (seeded_ && seeds_[bin]));
    }
    /// Whether pixels begin with a primitive from writeSeeds().
    bool seeded() const { return seeded_; }
    /// Numbers of the nearest triangles or spheres for some pixels of a row; 0: none, or no triangle is certain.
    void writeSeeds(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const {
        if (drawsSpheres_)
            frontSpheres_.write(x, y, count, to);
        else
            front_.write(x, y, count, to);
    }
    std::size_t kept() const { return kept_.size(); }  ///< primitives in any list
    std::size_t keptSpheres() const { return keptSpheres_; }
    std::size_t entries() const { return offsets_.empty() ? 0 : offsets_.back(); }
    std::uint32_t longest() const { return longest_; }  ///< entries of a list
    std::size_t words() const { return TileSet::words(entries()); }
    void write(std::uint32_t* to);

private:
    /// Triangles of one mesh with one transform: consecutive calls combined, because they share vertices.
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
    void addRound(const TileView& view, std::uint32_t number, glm::vec2 low, glm::vec2 high, float near, float reach);
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
    void mask(const TileView& view);
    void count();
    /// Whether a tile of a bin is drawn.
    bool drawsBin(std::size_t bin) const { return drawnBins_.empty() || drawnBins_[bin] != 0; }
    bool drawsAny(const Kept& k) const;
    void findSmall();
    void listTiles();

    std::uint32_t longest_ = 0;
    std::vector<std::uint8_t> drawnBins_;  // empty: all bins are drawn
    std::vector<Kept> kept_;
    std::vector<std::uint32_t> small_;  // primitives among them that are smaller than TileView::small
    std::vector<std::vector<Kept>> keptOfSlices_;
    std::size_t keptSpheres_ = 0;
    std::vector<std::uint32_t> order_, offsets_, cursors_;
    std::vector<Tile> bins_;
    std::vector<glm::vec4> corners_;  // pixel and Z of each vertex, transformed for a call
    bool seeded_ = false, drawsSpheres_ = false;
    std::vector<std::uint8_t> seeds_;  // per bin: some pixel has a seed
    std::vector<FrontTriangles::Run> runs_;
    TriangleLanes lanes_;
    FrontTriangles front_;
    FrontSpheres frontSpheres_;
};

}  // namespace nacre
