#include "engine/mesh/surface.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/error.h"
#include "engine/mesh/creases.h"
#include "engine/mesh/marching_cubes.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/mesh/probe_field.h"
#include "engine/mesh/solids.h"
#include "engine/mesh/surface_field.h"
#include "engine/threads.h"

namespace nacre {
namespace {

constexpr int kBlockCells = 32;                // along each edge of a block
constexpr double kSurfaceOfAtom = 5;           // Å^2 of a protein atom, as in 4HHB and 1AON
constexpr double kGaussianOfAtom = 10;         // the same: it enters crevices that no probe does
constexpr double kTrianglesPerCellFace = 2.3;  // triangles per grid cell face of surface area
constexpr double kAimedTriangles = 1.5e6;
constexpr double kFarthestCell = 1e9;  // cells from the middle: integers are exact up to here

double surfaceOfAtom(SurfaceKind kind) { return kind == SurfaceKind::gaussian ? kGaussianOfAtom : kSurfaceOfAtom; }

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

/// Cuts block after block. Visits only cells that the surface crosses: a row of nodes is a word with a bit per node,
/// set inside.
class BlockCutter {
public:
    static constexpr int kMostCells = 63;  ///< along x

    /// @param field  outlives this @param shift  of the vertices, Å
    BlockCutter(const SurfaceField& field, const glm::dvec3& shift) : field_(field), shift_(shift) {}

    /// @param sources  of the field that reach into the block
    BlockMesh cut(const GridBlock& block, std::span<const std::uint32_t> sources);

private:
    void findInside();
    void cutCell(const glm::ivec3& cell);
    std::uint32_t vertexOn(const glm::ivec3& cell, std::uint8_t number);

    const SurfaceField& field_;
    glm::dvec3 shift_;
    GridBlock block_;
    std::vector<float> values_;
    std::vector<std::uint32_t> origins_;
    std::vector<std::uint64_t> inside_;  // by row of nodes
    // by edge, for two layers of nodes in turn, and the edges from them to the next layer
    std::vector<std::uint32_t> vertices_;
    std::vector<GridCrossing> crossings_;  // by vertex
    std::vector<SurfacePoint> points_;
    BlockMesh result_;
};

glm::ivec3 cornerOffset(int c) { return {c & 1, c >> 1 & 1, c >> 2 & 1}; }

BlockMesh BlockCutter::cut(const GridBlock& block, std::span<const std::uint32_t> sources) {
    block_ = block;
    result_ = {};
    const glm::ivec3 n = block.nodes();
    const std::size_t nodes = static_cast<std::size_t>(n.x) * n.y * n.z,
                      layer = static_cast<std::size_t>(n.x) * n.y * 3;
    values_.resize(nodes);
    origins_.resize(nodes);
    field_.fill(block_, sources, values_, origins_);
    findInside();
    vertices_.assign(2 * layer, kNoSource);
    crossings_.clear();
    points_.clear();
    for (int z = 0; z + 1 < n.z; ++z) {
        for (int y = 0; y + 1 < n.y; ++y) {
            const std::uint64_t* rows = inside_.data() + static_cast<std::size_t>(z) * n.y + y;
            const std::uint64_t any = rows[0] | rows[1] | rows[n.y] | rows[n.y + 1];
            const std::uint64_t all = rows[0] & rows[1] & rows[n.y] & rows[n.y + 1];
            std::uint64_t cells = (any | any >> 1) & ~(all & all >> 1) & ((std::uint64_t{1} << (n.x - 1)) - 1);
            for (; cells != 0; cells &= cells - 1) cutCell(block_.first + glm::ivec3(std::countr_zero(cells), y, z));
        }
        std::fill_n(vertices_.begin() + static_cast<std::ptrdiff_t>(z % 2 * layer), layer, kNoSource);
    }
    field_.cross(block_, sources, crossings_, points_);
    for (const SurfacePoint& point : points_) addVertex(result_.mesh, point.place + shift_, point.normal, point.atom);
    return std::move(result_);
}

void BlockCutter::findInside() {
    const glm::ivec3 n = block_.nodes();
    inside_.resize(static_cast<std::size_t>(n.y) * n.z);
    const float* value = values_.data();
    for (std::uint64_t& row : inside_) {
        row = 0;
        for (int x = 0; x < n.x; ++x) row |= static_cast<std::uint64_t>(*value++ > 0) << x;
    }
}

void BlockCutter::cutCell(const glm::ivec3& cell) {
    const glm::ivec3 n = block_.nodes(), at = cell - block_.first;
    const std::uint64_t* rows = inside_.data() + static_cast<std::size_t>(at.z) * n.y + at.y;
    const std::size_t inside = (rows[0] >> at.x & 3) | (rows[1] >> at.x & 3) << 2 | (rows[n.y] >> at.x & 3) << 4 |
                               (rows[n.y + 1] >> at.x & 3) << 6;
    for (const CellTriangle& triangle : cellTriangles()[inside])
        result_.mesh.triangles.emplace_back(vertexOn(cell, triangle[0]), vertexOn(cell, triangle[1]),
                                            vertexOn(cell, triangle[2]));
}

std::uint32_t BlockCutter::vertexOn(const glm::ivec3& cell, std::uint8_t number) {
    const CellEdge edge = cellEdges()[number];
    const glm::ivec3 a = cell + cornerOffset(edge.from), b = cell + cornerOffset(edge.to), way = b - a;
    const int direction = way.x ? 0 : way.y ? 1 : 2;
    const glm::ivec3 n = block_.nodes(), place = a - block_.first;
    const std::size_t inTwoLayers = (static_cast<std::size_t>(place.z % 2) * n.y + place.y) * n.x + place.x;
    std::uint32_t& vertex = vertices_[3 * inTwoLayers + direction];
    if (vertex != kNoSource) return vertex;
    const std::size_t atA = block_.index(a), atB = block_.index(b);
    const GridCrossing::Node nodeA{block_.place(a), values_[atA], origins_[atA]};
    const GridCrossing::Node nodeB{block_.place(b), values_[atB], origins_[atB]};
    vertex = static_cast<std::uint32_t>(crossings_.size());
    crossings_.push_back(values_[atA] > 0 ? GridCrossing{nodeA, nodeB} : GridCrossing{nodeB, nodeA});
    for (int i = 0; i < 3; ++i)
        if (i != direction && (a[i] == block_.first[i] || a[i] == block_.last[i])) {
            result_.shared.emplace_back(vertex, GridEdge{a, direction});
            break;
        }
    return vertex;
}

struct BlockOrder {
    bool operator()(const glm::ivec3& a, const glm::ivec3& b) const {
        return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
    }
};

/// Non-empty blocks, with the sources that reach each.
std::map<glm::ivec3, std::vector<std::uint32_t>, BlockOrder> listBlocks(const SurfaceField& field, double step) {
    std::map<glm::ivec3, std::vector<std::uint32_t>, BlockOrder> blocks;
    const auto boxes = field.reaches();
    const double size = step * kBlockCells;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        // A node on the border belongs to two blocks.
        const glm::ivec3 low(glm::floor((boxes[i][0] - step * 1e-3) / size)),
            high(glm::floor((boxes[i][1] + step * 1e-3) / size));
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) blocks[{x, y, z}].push_back(i);
    }
    return blocks;
}

/// Joins the meshes of all blocks. Vertices on shared edges are merged.
Mesh joined(std::vector<BlockMesh>& blocks) {
    Mesh mesh;
    std::unordered_map<GridEdge, std::uint32_t, GridEdgeHash> known;
    std::size_t vertices = 0, triangles = 0;
    for (const BlockMesh& block : blocks) {
        vertices += block.mesh.positions.size();
        triangles += block.mesh.triangles.size();
    }
    mesh.positions.reserve(vertices);
    mesh.normals.reserve(vertices);
    mesh.atoms.reserve(vertices);
    mesh.triangles.reserve(triangles);
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
std::vector<SurfaceBall> makeBalls(const Molecule& molecule, std::span<const std::uint32_t> atoms,
                                   const SurfaceOptions& options, const glm::dvec3& middle, double margin) {
    std::vector<SurfaceBall> balls;
    for (const std::uint32_t index : atoms) {
        const Atom& atom = molecule.atoms[index];
        const glm::dvec3 place = glm::dvec3(atom.position) - middle;
        if (std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z))
            balls.push_back(
                {place,
                 options.scale * static_cast<double>(atom.radius > 0 ? atom.radius : options.radius(atom.element)) +
                     margin,
                 index});
    }
    return balls;
}

glm::dvec3 findMiddle(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
    glm::dvec3 low(1e30), high(-1e30);
    for (const std::uint32_t index : atoms) {
        const glm::dvec3 p(molecule.atoms[index].position);
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return low.x <= high.x ? (low + high) / 2.0 : glm::dvec3();
}

/// @param count  in millions
[[noreturn]] void refuseTriangles(std::size_t count) {
    throw Error("cannot make surface", "",
                "it would have some " + std::to_string(count) + " million triangles, more than the limit of " +
                    std::to_string(kMostSurfaceTriangles / 1000000) + " (fewer atoms, or a coarser resolution)");
}

/// Refuses a surface that would be too large, or whose atoms crowd at one place, by an estimate from its atoms.
void checkSurfaceSize(const std::vector<SurfaceBall>& balls, SurfaceKind kind, double step) {
    constexpr double kMostLayers = 10'000;  // as in any scene: engine/scene/build/crowd.h
    double farthest = 0, apart = 0, reach = 0;
    for (const SurfaceBall& ball : balls) {
        farthest = std::max({farthest, std::abs(ball.center.x), std::abs(ball.center.y), std::abs(ball.center.z)});
        apart += 4 * std::numbers::pi * ball.radius * ball.radius;
        reach = std::max(reach, glm::length(ball.center) + ball.radius);
    }
    const double layers = apart / (4 * std::numbers::pi * reach * reach);
    if (layers > kMostLayers)
        throw Error("cannot make surface", "",
                    "its atoms lie over one another " + std::to_string(std::llround(layers)) +
                        " times, more than the limit of " + std::to_string(std::llround(kMostLayers)));
    const double area = std::min(apart, surfaceOfAtom(kind) * static_cast<double>(balls.size()));
    const double triangles = kTrianglesPerCellFace * area / (step * step);
    if (triangles > static_cast<double>(kMostSurfaceTriangles))
        refuseTriangles(static_cast<std::size_t>(std::llround(triangles / 1e6)));
    if (farthest / step > kFarthestCell) throw Error("cannot make surface", "", "its atoms are too far apart");
}

void setMargins(Mesh& mesh, const std::vector<SurfaceBall>& balls, const glm::dvec3& shift) {
    const auto last = std::max_element(balls.begin(), balls.end(), [](auto& a, auto& b) { return a.atom < b.atom; });
    std::vector<std::uint32_t> ballIndex(last->atom + 1);
    for (std::uint32_t i = 0; i < balls.size(); ++i) ballIndex[balls[i].atom] = i;
    const auto height = [&](std::uint32_t atom, std::uint32_t vertex) {
        const SurfaceBall& ball = balls[ballIndex[atom]];
        return glm::distance(ball.center, glm::dvec3(mesh.positions[vertex]) - shift) - ball.radius;
    };
    constexpr float kFar = 1e9f;
    mesh.margins.assign(mesh.positions.size(), kFar);
    for (const glm::uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            for (const std::uint32_t other : {t[(i + 1) % 3], t[(i + 2) % 3]}) {
                const std::uint32_t own = mesh.atoms[t[i]], next = mesh.atoms[other];
                if (own == next) continue;
                const auto margin = static_cast<float>(height(next, t[i]) - height(own, t[i]));
                mesh.margins[t[i]] = std::min(mesh.margins[t[i]], std::max(margin, 0.0f));
            }
    float widest = 0;
    for (const float margin : mesh.margins)
        if (margin < kFar) widest = std::max(widest, margin);
    for (float& margin : mesh.margins) margin = std::min(margin, widest);
}

}  // namespace

NodeRange::NodeRange(const GridBlock& block, const glm::dvec3& low, const glm::dvec3& high) {
    const glm::dvec3 from = glm::max(glm::ceil(low / block.step), glm::dvec3(block.first));
    const glm::dvec3 to = glm::min(glm::floor(high / block.step), glm::dvec3(block.last));
    first = glm::ivec3(glm::min(from, glm::dvec3(block.last + 1)));
    last = glm::ivec3(glm::max(to, glm::dvec3(block.first - 1)));
}

double surfaceResolution(std::size_t atoms, SurfaceKind kind) {
    const double area = surfaceOfAtom(kind) * static_cast<double>(atoms);
    return std::clamp(std::sqrt(kTrianglesPerCellFace * area / kAimedTriangles), 0.4, kCoarsestSurface);
}

Mesh surface(const Molecule& molecule, std::span<const std::uint32_t> atoms, const SurfaceOptions& options,
             const glm::dvec3& origin) {
    const glm::dvec3 middle = findMiddle(molecule, atoms);
    const bool accessible = options.kind == SurfaceKind::solventAccessible;
    const double probe = std::clamp(options.probe, 0.0, kLargestProbe);
    const std::vector<SurfaceBall> balls = makeBalls(molecule, atoms, options, middle, accessible ? probe : 0);
    if (balls.empty()) return {};
    const double wanted = options.resolution > 0 ? options.resolution : surfaceResolution(balls.size(), options.kind);
    const double step = std::clamp(wanted, kFinestSurface, kCoarsestSurface);
    checkSurfaceSize(balls, options.kind, step);
    const std::unique_ptr<SurfaceField> field =
        options.kind == SurfaceKind::gaussian ? gaussianField(balls) : probeField(balls, accessible ? 0 : probe, step);
    const auto blocks = listBlocks(*field, step);
    std::vector<std::pair<glm::ivec3, const std::vector<std::uint32_t>*>> list;
    for (const auto& [place, sources] : blocks) list.emplace_back(place, &sources);
    std::vector<BlockMesh> meshes(list.size());
    std::atomic<std::size_t> next{0}, triangles{0};
    inParallel(std::min<std::size_t>(threadsPerTask(), list.size()), [&](std::size_t) {
        BlockCutter cutter(*field, middle - origin);  // reuses its memory for each block
        for (std::size_t i = next++; i < list.size(); i = next++) {
            const glm::ivec3 first = list[i].first * kBlockCells;
            meshes[i] = cutter.cut({first, first + kBlockCells, step}, *list[i].second);
            // The estimate assumes a protein's surface per atom. Separate atoms have more.
            if ((triangles += meshes[i].mesh.triangles.size()) > kMostSurfaceTriangles)
                refuseTriangles(triangles * list.size() / (i + 1) / 1'000'000);
        }
    });
    Mesh mesh = joined(meshes);
    if (!options.cavities) dropCavities(mesh);  // uses connectivity, which creases interrupt
    if (options.kind != SurfaceKind::gaussian && (accessible || probe == 0))
        putCreases(mesh, balls, middle - origin, step);  // along borders
    else
        setMargins(mesh, balls, middle - origin);
    return mesh;
}

}  // namespace nacre
