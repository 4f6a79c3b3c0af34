#pragma once
// A function on the nodes of a grid whose zero level is a surface.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nacre {

/// A ball that contributes to a surface.
struct SurfaceBall {
    glm::dvec3 center{};  ///< Å
    double radius = 0;    ///< Å, van der Waals
    std::uint32_t atom = 0;
};

constexpr std::uint32_t kNoSource = 0xffffffffu;

/// Nodes first to last (inclusive) of a grid: node i is at i * step.
struct GridBlock {
    glm::ivec3 first{}, last{};
    double step = 1;
    glm::ivec3 nodes() const { return last - first + 1; }
    std::size_t index(const glm::ivec3& node) const {
        const glm::ivec3 n = nodes(), at = node - first;
        return (static_cast<std::size_t>(at.z) * n.y + at.y) * n.x + at.x;
    }
    glm::dvec3 place(const glm::ivec3& node) const { return glm::dvec3(node) * step; }
};

/// Nodes of a block within a box (Å). Empty: `last` is before `first`.
struct NodeRange {
    glm::ivec3 first{}, last{};
    NodeRange(const GridBlock& block, const glm::dvec3& low, const glm::dvec3& high);
};

struct SurfacePoint {
    glm::dvec3 place{}, normal{};
    std::uint32_t atom = 0;
};

/// An edge of the grid that the surface crosses.
struct GridCrossing {
    struct Node {
        glm::dvec3 place{};
        double value = 0;
        std::uint32_t origin = kNoSource;
    };
    Node inside, outside;
};

/// A field that is positive inside. Its value at a node does not depend on the block.
class SurfaceField {
public:
    virtual ~SurfaceField() = default;

    /// Boxes (low, high) of the sources, in order; nodes outside all of them are outside the surface. A block is filled
    /// from the boxes that reach into it.
    virtual std::vector<std::array<glm::dvec3, 2>> reaches() const = 0;
    /// @param sources  indices of reaches, ascending
    /// @param values, origins  per node of the block: the value, and its source
    virtual void fill(const GridBlock& block, std::span<const std::uint32_t> sources, std::vector<float>& values,
                      std::vector<std::uint32_t>& origins) const = 0;
    /// Adds the point of each crossing of a block, in order.
    virtual void cross(const GridBlock& block, std::span<const std::uint32_t> sources,
                       std::span<const GridCrossing> crossings, std::vector<SurfacePoint>& points) const = 0;
};

}  // namespace nacre
