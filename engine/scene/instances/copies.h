#pragma once
// Assemblies by instancing: one set of primitives, and the transforms of its runs.

#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/molecule/molecule.h"
#include "engine/scene/view/bounds.h"

namespace nacre {

/// Consecutive spheres, cylinders or triangles that have the same copies.
struct PrimitiveRun {
    std::uint32_t first = 0, count = 0;
    std::uint32_t list = 0;  ///< index into Copies::lists
    glm::dvec3 center{};     ///< of the run's bounding sphere as stored, Å
    double radius = 0;
};

/// Copies of runs of primitives. Without transforms everything is drawn once, as stored.
struct Copies {
    std::vector<glm::dmat4x3> transforms;           ///< p -> transform * vec4(p, 1); all different
    std::vector<std::vector<std::uint32_t>> lists;  ///< indices of transforms, ascending; all different
    /// In primitive order; together they cover all.
    std::vector<PrimitiveRun> spheres, cylinders, triangles;
    /// Colours that copies cycle through if a primitive's colour is a tint (isCopyTint), packed as in colors.h, at most
    /// kMostCopyColors. Empty: all copies look the same.
    std::vector<std::uint32_t> colors;
};

/// Limit of the shaders (shaders/common/layout.h).
constexpr std::size_t kMostCopyColors = 16;

/// An order of copies in which those that share one of `colors` cycled colours are far apart; for more than 65,536
/// copies, one in which neighbours mostly differ.
/// @param centers  of the copies
std::vector<std::uint32_t> spreadCopies(const std::vector<glm::dvec3>& centers, std::size_t colors);

/// Whether shape and size stay, to half a percent: a radius cannot be stretched in one direction.
bool isRigid(const glm::dmat4x3& motion);

/// Transforms of a molecule's subchains in an assembly.
struct Placement {
    static constexpr std::uint32_t kNowhere = UINT32_MAX;
    std::vector<glm::dmat4x3> transforms;  ///< in the file's frame
    std::vector<std::vector<std::uint32_t>> lists;
    std::vector<std::uint32_t> listOfSubchain;  ///< kNowhere: not in the assembly
};

/// @throws Error if no assembly has the id (lists the ids), a transform is not a rigid motion, or the lists are too
/// long
Placement placeAssembly(const Molecule& molecule, const std::string& id);

/// Finds lists of copies by their contents. Bonds between many parts need as many lists as there are bonds.
class CopyLists {
public:
    /// @param lists  outlives this and is not moved; call index() after changing its lists
    explicit CopyLists(std::vector<std::vector<std::uint32_t>>& lists) : lists_(lists), order_(Order{this}) { index(); }
    CopyLists(const CopyLists&) = delete;
    void index();

    /// The list of these copies; added if missing. @param list  ascending
    std::uint32_t add(std::vector<std::uint32_t> list);
    /// The list with the intersection of two lists; added if missing. Placement::kNowhere if it is empty.
    /// @throws Error if the lists added for this are too long
    std::uint32_t common(std::uint32_t a, std::uint32_t b);
    /// Lists compared so far.
    std::uint64_t comparisons() const { return comparisons_; }

private:
    struct Order {
        CopyLists* of;
        bool operator()(std::uint32_t a, std::uint32_t b) const {
            ++of->comparisons_;
            return of->lists_[a] < of->lists_[b];
        }
    };
    std::vector<std::vector<std::uint32_t>>& lists_;
    std::set<std::uint32_t, Order> order_;  // no hash that a file could aim at
    std::uint64_t comparisons_ = 0;
    std::size_t added_ = 0;  // places in lists of common()
};

/// The relative placement of two copies, and all pairs of copies with it: in the first copy's own frame, `image` moves
/// the first to the second.
struct CopyRelation {
    glm::dmat4x3 image;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

constexpr std::size_t kMostRelations = 400;  ///< a capsid has about ten
constexpr std::size_t kMostRelatedCopies = 4096;

/// Relations of copies whose spheres come within `reach` (Å) of each other; each pair is in one relation.
/// Empty if there are more than kMostRelatedCopies copies or kMostRelations relations.
std::optional<std::vector<CopyRelation>> copyRelations(const std::vector<glm::dmat4x3>& transforms,
                                                       const Bounds& sphere, double reach);

/// Representatives of equivalent copies: if an assembly looks the same from one copy as from another (60 copies of a
/// capsid's protein), only one of them is needed. Found numerically: by the motions that take copy 0 to another one and
/// every copy onto some copy.
/// @param reach  Å from the origin within which copies must agree to 0.1 Å
/// @param list   of transforms; with more than 4,096, each represents itself
std::vector<std::uint32_t> representativeCopies(const std::vector<glm::dmat4x3>& transforms,
                                                const std::vector<std::uint32_t>& list, double reach);

}  // namespace nacre
