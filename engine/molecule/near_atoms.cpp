#include "engine/molecule/near_atoms.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nacre {
namespace {

constexpr std::uint32_t kAtomsOfLeaf = 8;

/// A tree of boxes, each around half of its parent's points. A grid would do for small distances, but its cells fill up
/// if the distance is large or one atom lies far away.
class PointTree {
public:
    explicit PointTree(std::vector<glm::vec3> points) : points_(std::move(points)) {
        nodes_.reserve(points_.size() / 2 + 1);
        build(0, static_cast<std::uint32_t>(points_.size()));
    }

    bool anyWithin(const glm::dvec3& from, double squared) const {
        std::array<std::uint32_t, 64> waiting;  // a tree over 2^32 points is 30 deep
        std::size_t count = 0;
        waiting[count++] = 0;
        while (count > 0) {
            const Node& node = nodes_[waiting[--count]];
            if (nearest(node, from) > squared) continue;
            if (farthest(node, from) <= squared) return true;
            if (node.right == 0) {
                for (std::uint32_t i = node.begin; i < node.end; ++i) {
                    const glm::dvec3 way = glm::dvec3(points_[i]) - from;
                    if (glm::dot(way, way) <= squared) return true;
                }
                continue;
            }
            const auto left = static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
            const bool leftFirst = nearest(nodes_[left], from) <= nearest(nodes_[node.right], from);
            waiting[count++] = leftFirst ? node.right : left;
            waiting[count++] = leftFirst ? left : node.right;
        }
        return false;
    }

private:
    struct Node {
        glm::vec3 low, high;  ///< bounds of its points
        std::uint32_t begin, end;
        std::uint32_t right;  ///< the second half; the first one is the next node. 0: a leaf
    };

    std::uint32_t build(std::uint32_t begin, std::uint32_t end) {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        glm::vec3 low = points_[begin], high = low;
        for (std::uint32_t i = begin; i < end; ++i) {
            low = glm::min(low, points_[i]);
            high = glm::max(high, points_[i]);
        }
        nodes_.push_back({low, high, begin, end, 0});
        if (end - begin <= kAtomsOfLeaf) return index;
        const glm::vec3 size = high - low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                         [=](const glm::vec3& a, const glm::vec3& b) { return a[axis] < b[axis]; });
        build(begin, middle);
        nodes_[index].right = build(middle, end);
        return index;
    }

    /// Squared distances to the nearest and to the farthest point of a node's box.
    static double nearest(const Node& node, const glm::dvec3& from) {
        const glm::dvec3 way = glm::max(glm::max(glm::dvec3(node.low) - from, from - glm::dvec3(node.high)), 0.0);
        return glm::dot(way, way);
    }
    static double farthest(const Node& node, const glm::dvec3& from) {
        const glm::dvec3 way = glm::max(glm::abs(glm::dvec3(node.low) - from), glm::abs(glm::dvec3(node.high) - from));
        return glm::dot(way, way);
    }

    std::vector<glm::vec3> points_;
    std::vector<Node> nodes_;
};

}  // namespace

std::vector<bool> atomsNear(const Molecule& molecule, const std::vector<bool>& marked, double distance) {
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < marked.size(); ++i)
        if (marked[i]) points.push_back(molecule.atoms[i].position);
    std::vector<bool> near = marked;
    if (points.empty()) return near;
    const PointTree tree(std::move(points));
    for (std::size_t i = 0; i < near.size(); ++i)
        if (!near[i]) near[i] = tree.anyWithin(glm::dvec3(molecule.atoms[i].position), distance * distance);
    return near;
}

}  // namespace nacre
