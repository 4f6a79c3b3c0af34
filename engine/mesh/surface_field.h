#pragma once
// What a surface is the boundary of, as a function on the nodes of a grid.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nacre {

/// A ball that a surface is made of.
struct SurfaceBall {
    glm::dvec3 center{};  ///< Å
    double radius = 0;    ///< Å, van der Waals
    std::uint32_t atom = 0;
};

constexpr std::uint32_t kNoSource = 0xffffffffu;

/// Nodes first to last (both included) of a grid: node i stands at i * step.
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

/// Nodes of a block within a box (Å); `last` is before `first` where there is none.
struct NodeRange {
    glm::ivec3 first{}, last{};
    NodeRange(const GridBlock& block, const glm::dvec3& low, const glm::dvec3& high);
};

struct SurfacePoint {
    glm::dvec3 place{}, normal{};
    std::uint32_t atom = 0;
};

/// Positive inside, and to be found at each node the same whichever block it is asked for in.
class SurfaceField {
public:
    virtual ~SurfaceField() = default;

    /// Boxes (low, high) outside of which a node is outside, whatever is known of sources; in their order. A block is
    /// filled from those that reach into it.
    virtual std::vector<std::array<glm::dvec3, 2>> reaches() const = 0;
    /// @param sources  numbers of reaches, ascending
    /// @param values, origins  of each node of the block: the value, and by what it is so
    virtual void fill(const GridBlock& block, std::span<const std::uint32_t> sources, std::vector<float>& values,
                      std::vector<std::uint32_t>& origins) const = 0;
    /// Where the surface crosses the line between two neighbouring nodes.
    struct Node {
        glm::dvec3 place{};
        double value = 0;
        std::uint32_t origin = kNoSource;
    };
    virtual SurfacePoint cross(const Node& inside, const Node& outside) const = 0;
};

}  // namespace nacre
