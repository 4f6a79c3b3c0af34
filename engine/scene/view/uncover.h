#pragma once
// Uncovers a part of a scene, even in a deep pocket: removes everything in front of it in a view.

#include <cstddef>
#include <vector>

#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre {

constexpr double kStillCovered = 0.02;  ///< largest fraction of a part that may stay covered, by atoms that touch its
                                        ///< outline
constexpr double kBuried = 0.1;         ///< from this fraction on a part counts as buried: its pocket is opened

/// Removed primitives, as stored: in an assembly they are removed from every copy.
struct Uncovered {
    std::size_t spheres = 0, cylinders = 0, triangles = 0;
    double before = 1;  ///< visible fraction of the part's own picture before
    double after = 1;   ///< likewise after it, at least
};

/// Removes atoms, sticks and patches of meshes that cover chosen atoms (in their first copy); those that cover least
/// stay, up to kStillCovered together. If kBuried or more is covered, also removes everything nearer than the part's
/// nearest point, unless there are copies of it. Removes whole atoms, sticks with their atoms, and atoms with their
/// last stick, so that nothing floats; a mesh patch is the part with one atom's look. Translucent parts cover nothing.
/// The scene keeps its centre, radius and counts of atoms and bonds.
/// @param chosen    one value per atom of the file; if none of them is drawn, removes nothing
/// @param clipNear  Å from the centre away from the viewer: a plane clips everything nearer
Uncovered uncover(Representation& scene, const std::vector<bool>& chosen, const View& view, double clipNear);

}  // namespace nacre
