#include "engine/mesh/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/error.h"
#include "engine/mesh/creases.h"
#include "engine/mesh/marching_cubes.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/mesh/probe_field.h"
#include "engine/mesh/solids.h"
#include "engine/mesh/surface_field.h"
#include "engine/molecule/element.h"
#include "engine/threads.h"

namespace nacre {
namespace {

constexpr int kBlockCells = 32;                // along each edge of a block
constexpr double kSurfaceOfAtom = 5;           // Å^2, of a protein, as 4HHB's and 1AON's have it
constexpr double kTrianglesPerCellFace = 2.3;  // of a surface of a cell's face
constexpr double kAimedTriangles = 1.5e6;
constexpr double kFarthestCell = 1e9;  // cells from the middle: where whole numbers are still exact

/// An edge of the grid, by its lower node and its direction.
struct GridEdge {
    glm::ivec3 node{};
    int direction = 0;
    friend bool operator==(const GridEdge&, const GridEdge&) = default;
};
struct GridEdgeHash {
    std::size_t operator()(const GridEdge& edge) const {
        std::size_t h = static_cast<std::size_t>(edge.direction);
        for (const int v : {edge.node.x, edge.node.y, edge.node.z})
            h = (h ^ static_cast<std::size_t>(static_cast<unsigned>(v))) * 0x9e3779b97f4a7c15u;
        return h ^ h >> 32;
    }
};

/// Output of a block: a mesh, and its vertices shared with other blocks.
struct BlockMesh {
    Mesh mesh;
    std::vector<std::pair<std::uint32_t, GridEdge>> shared;
};

/// Cuts one block.
class BlockCutter {
public:
    BlockCutter(const SurfaceField& field, const GridBlock& block, const glm::dvec3& shift)
        : field_(field), block_(block), shift_(shift) {
        const glm::ivec3 n = block.nodes();
        values_.resize(static_cast<std::size_t>(n.x) * n.y * n.z);
        origins_.resize(values_.size());
    }

    BlockMesh cut(std::span<const std::uint32_t> sources) {
        field_.fill(block_, sources, values_, origins_);
        const auto isInside = [](float value) { return value > 0; };
        if (std::none_of(values_.begin(), values_.end(), isInside)) return {};
        vertices_.assign(values_.size() * 3, kNoSource);
        for (int z = block_.first.z; z < block_.last.z; ++z)
            for (int y = block_.first.y; y < block_.last.y; ++y)
                for (int x = block_.first.x; x < block_.last.x; ++x) cutCell({x, y, z});
        return std::move(result_);
    }

private:
    static glm::ivec3 corner(int c) { return {c & 1, c >> 1 & 1, c >> 2 & 1}; }

    void cutCell(const glm::ivec3& cell) {
        std::size_t inside = 0;
        for (int c = 0; c < kCellCorners; ++c)
            if (values_[block_.index(cell + corner(c))] > 0) inside |= std::size_t{1} << c;
        for (const CellTriangle& triangle : cellTriangles()[inside])
            result_.mesh.triangles.emplace_back(vertexOn(cell, triangle[0]), vertexOn(cell, triangle[1]),
                                                vertexOn(cell, triangle[2]));
    }

    std::uint32_t vertexOn(const glm::ivec3& cell, std::uint8_t number) {
        const CellEdge edge = cellEdges()[number];
        const glm::ivec3 a = cell + corner(edge.from), b = cell + corner(edge.to), way = b - a;
        const int direction = way.x ? 0 : way.y ? 1 : 2;
        const std::size_t atA = block_.index(a), atB = block_.index(b);
        std::uint32_t& vertex = vertices_[3 * atA + direction];
        if (vertex != kNoSource) return vertex;
        const SurfaceField::Node nodeA{block_.place(a), values_[atA], origins_[atA]};
        const SurfaceField::Node nodeB{block_.place(b), values_[atB], origins_[atB]};
        const bool aInside = values_[atA] > 0;
        const SurfacePoint point = field_.cross(aInside ? nodeA : nodeB, aInside ? nodeB : nodeA);
        vertex = addVertex(result_.mesh, point.place + shift_, point.normal, point.atom);
        for (int i = 0; i < 3; ++i)
            if (i != direction && (a[i] == block_.first[i] || a[i] == block_.last[i])) {
                result_.shared.emplace_back(vertex, GridEdge{a, direction});
                break;
            }
        return vertex;
    }

    const SurfaceField& field_;
    GridBlock block_;
    glm::dvec3 shift_;
    std::vector<float> values_;
    std::vector<std::uint32_t> origins_, vertices_;
    BlockMesh result_;
};

struct BlockOrder {
    bool operator()(const glm::ivec3& a, const glm::ivec3& b) const {
        return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
    }
};

/// Non-empty blocks, with the sources that reach into them.
std::map<glm::ivec3, std::vector<std::uint32_t>, BlockOrder> blocksOf(const SurfaceField& field, double step) {
    std::map<glm::ivec3, std::vector<std::uint32_t>, BlockOrder> blocks;
    const auto boxes = field.reaches();
    const double size = step * kBlockCells;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        // A node on the border is in two blocks.
        const glm::ivec3 low(glm::floor((boxes[i][0] - step * 1e-3) / size)),
            high(glm::floor((boxes[i][1] + step * 1e-3) / size));
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) blocks[{x, y, z}].push_back(i);
    }
    return blocks;
}

/// One mesh of all blocks', whose vertices on common edges are one.
Mesh joined(std::vector<BlockMesh>& blocks) {
    Mesh mesh;
    std::unordered_map<GridEdge, std::uint32_t, GridEdgeHash> known;
    for (BlockMesh& block : blocks) {
        std::vector<std::uint32_t> places(block.mesh.positions.size(), kNoSource);
        for (const auto& [vertex, edge] : block.shared)
            if (const auto found = known.find(edge); found != known.end()) places[vertex] = found->second;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i] != kNoSource) continue;
            places[i] = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.push_back(block.mesh.positions[i]);
            mesh.normals.push_back(block.mesh.normals[i]);
            mesh.atoms.push_back(block.mesh.atoms[i]);
        }
        for (const auto& [vertex, edge] : block.shared) known.emplace(edge, places[vertex]);
        for (const glm::uvec3& t : block.mesh.triangles)
            mesh.triangles.emplace_back(places[t.x], places[t.y], places[t.z]);
        block = {};
    }
    return mesh;
}

/// @param margin  Å, added to the radii
std::vector<SurfaceBall> ballsOf(const Molecule& molecule, std::span<const std::uint32_t> atoms,
                                 const SurfaceOptions& options, const glm::dvec3& middle, double margin) {
    std::vector<SurfaceBall> balls;
    for (const std::uint32_t index : atoms) {
        const Atom& atom = molecule.atoms[index];
        const glm::dvec3 place = glm::dvec3(atom.position) - middle;
        if (std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z))
            balls.push_back({place, options.scale * static_cast<double>(options.radius(atom.element)) + margin, index});
    }
    return balls;
}

glm::dvec3 middleOf(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
    glm::dvec3 low(1e30), high(-1e30);
    for (const std::uint32_t index : atoms) {
        const glm::dvec3 p(molecule.atoms[index].position);
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return low.x <= high.x ? (low + high) / 2.0 : glm::dvec3();
}

/// Refuses a surface that would be too large, before it is made: estimated from its atoms.
void checkSurfaceSize(const std::vector<SurfaceBall>& balls, double step) {
    double farthest = 0, apart = 0;
    for (const SurfaceBall& ball : balls) {
        farthest = std::max({farthest, std::abs(ball.center.x), std::abs(ball.center.y), std::abs(ball.center.z)});
        apart += 4 * std::numbers::pi * ball.radius * ball.radius;
    }
    const double area = std::min(apart, kSurfaceOfAtom * static_cast<double>(balls.size()));
    const double triangles = kTrianglesPerCellFace * area / (step * step);
    if (triangles > static_cast<double>(kMostSurfaceTriangles))
        throw Error("cannot make surface", "",
                    "it would have some " + std::to_string(std::llround(triangles / 1e6)) +
                        " million triangles, more than the limit of " +
                        std::to_string(kMostSurfaceTriangles / 1000000) + " (fewer atoms, or a coarser resolution)");
    if (farthest / step > kFarthestCell) throw Error("cannot make surface", "", "its atoms are too far apart");
}

}  // namespace

NodeRange::NodeRange(const GridBlock& block, const glm::dvec3& low, const glm::dvec3& high) {
    const glm::dvec3 from = glm::max(glm::ceil(low / block.step), glm::dvec3(block.first));
    const glm::dvec3 to = glm::min(glm::floor(high / block.step), glm::dvec3(block.last));
    first = glm::ivec3(glm::min(from, glm::dvec3(block.last + 1)));
    last = glm::ivec3(glm::max(to, glm::dvec3(block.first - 1)));
}

double surfaceResolution(std::size_t atoms) {
    const double area = kSurfaceOfAtom * static_cast<double>(atoms);
    return std::clamp(std::sqrt(kTrianglesPerCellFace * area / kAimedTriangles), 0.4, kCoarsestSurface);
}

Mesh surface(const Molecule& molecule, std::span<const std::uint32_t> atoms, const SurfaceOptions& options,
             const glm::dvec3& origin) {
    const glm::dvec3 middle = middleOf(molecule, atoms);
    const bool accessible = options.kind == SurfaceKind::solventAccessible;
    const double probe = std::clamp(options.probe, 0.0, kLargestProbe);
    const std::vector<SurfaceBall> balls = ballsOf(molecule, atoms, options, middle, accessible ? probe : 0);
    if (balls.empty()) return {};
    const double wanted = options.resolution > 0 ? options.resolution : surfaceResolution(balls.size());
    const double step = std::clamp(wanted, kFinestSurface, kCoarsestSurface);
    checkSurfaceSize(balls, step);
    const std::unique_ptr<SurfaceField> field =
        options.kind == SurfaceKind::gaussian ? gaussianField(balls) : probeField(balls, accessible ? 0 : probe, step);
    const auto blocks = blocksOf(*field, step);
    std::vector<std::pair<glm::ivec3, const std::vector<std::uint32_t>*>> list;
    for (const auto& [place, sources] : blocks) list.emplace_back(place, &sources);
    std::vector<BlockMesh> meshes(list.size());
    inParallel(list.size(), [&](std::size_t i) {
        const glm::ivec3 first = list[i].first * kBlockCells;
        meshes[i] = BlockCutter(*field, {first, first + kBlockCells, step}, middle - origin).cut(*list[i].second);
    });
    Mesh mesh = joined(meshes);
    if (!options.cavities) dropCavities(mesh);  // by connectivity, which creases break
    if (options.kind != SurfaceKind::gaussian && (accessible || probe == 0))
        putCreases(mesh, balls, middle - origin, step);
    return mesh;
}

}  // namespace nacre
