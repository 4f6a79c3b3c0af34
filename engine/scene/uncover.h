#pragma once
// A part of a scene that is to be seen whole, deep in a pocket or not: what stands before it in a view is left out.

#include <cstddef>
#include <vector>

#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre {

constexpr double kStillCovered = 0.02;  ///< share of a part that stays covered, at most: by what touches its outline
constexpr double kBuried = 0.1;         ///< from this share on it lies in a pocket, and that is opened

/// What was left out, as stored: of an assembly it is missing in every copy.
struct Uncovered {
    std::size_t spheres = 0, cylinders = 0, triangles = 0;
    double before = 1;  ///< share of what the part shows by itself that was seen
    double after = 1;   ///< and is now, at least
};

/// Leaves out atoms, sticks and patches of meshes that cover a choice of atoms (where its first copy stands): all but
/// those that cover the least of it, kStillCovered together. Where kBuried of it or more is covered, all else that
/// stands nearer than its nearest place goes, too, unless there are copies of it. Atoms go whole, a stick with its
/// atoms, and an atom with the last of its sticks, so that nothing is left in the air; a patch of a mesh is what has
/// the look of one atom. What one looks through covers nothing. The scene keeps its centre, radius and counts of atoms
/// and bonds.
/// @param chosen    one value per atom of the file; where none of it is drawn, nothing is left out
/// @param clipNear  Å from the centre away from the viewer: what is nearer is cut away by a plane
Uncovered uncover(Representation& scene, const std::vector<bool>& chosen, const View& view, double clipNear);

}  // namespace nacre
