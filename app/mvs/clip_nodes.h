#pragma once
// The clip nodes of a representation or a group of primitives: planes, spheres and boxes that cut parts away.

#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/mvs/scene_parts.h"

namespace nacre::app::mvs {

class ClipRegions {
public:
    /// Reads the clip nodes among the children. Omits a faulty node, with a warning.
    ClipRegions(const Node& parent, SceneWarnings& warnings);

    bool empty() const { return regions_.empty(); }
    /// Whether a point, in the scene's frame, is cut away.
    bool cuts(const glm::dvec3& point) const;
    enum class Cut { none, some, all };
    /// How much of a ball is cut away. `some` may also be none or all.
    Cut cutsBall(const glm::dvec3& center, double radius) const;
    /// Whether whole chains are cut, by their centres: the first node's variant.
    bool cutObjects() const { return cutObjects_; }

private:
    /// A point is inside if, in the region's own frame, y >= 0 (a plane), it lies in the unit ball, or in the unit
    /// cube.
    struct Region {
        enum class Shape { plane, ball, cube } shape;
        glm::dmat4x3 toOwn{1.0};
        bool inverted = false;
        /// How far a point is inside, in the region's own frame; negative: outside.
        double depth(const glm::dvec3& point) const;
    };
    static Region readRegion(const Node& node, const std::string& type);

    std::vector<Region> regions_;
    bool cutObjects_ = false;
};

/// Drops clipped parts of a layer by their centres: atoms, residues of cartoons and backbones, or whole chains.
/// @param structure  each of its residues has at most one copy, or its copies are cut alike
void clipLayer(const ClipRegions& regions, const Structure& structure, SceneLayer& layer);

constexpr std::size_t kMostCutAtoms = 4'000'000;  ///< of the copies that a clip cuts through

/// Gives copies that a clip cuts through atoms of their own, and cuts `layer`.
/// @returns the structure that `layer` belongs to from now on; empty: its own structure as before
std::optional<Structure> separateCut(const Node& representation, const ClipRegions& regions, const Structure& structure,
                                     SceneLayer& layer, SceneFiles& files, SceneWarnings& warnings);

/// Drops clipped primitives by their centres, and triangles of meshes.
void clipPrimitives(const ClipRegions& regions, Primitives& primitives);

}  // namespace nacre::app::mvs
