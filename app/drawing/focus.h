#pragma once
// The point that a camera looks at: maps are drawn around it.

#include <glm/vec3.hpp>

#include "app/picture/description.h"
#include "engine/molecule/molecule.h"
#include "engine/settings.h"

namespace nacre::app {

/// A camera after aiming, and the radius that it takes in (Å).
struct Seen {
    Camera camera;
    double radius = 0;
};

/// The place in the picture's middle, Å in the file's frame: at the depth of what --zoom-to or --uncover names, else of
/// the nearest drawn atom in front of which nothing is, within 2 Å of the line of sight; else of the atom that is
/// closest to that line.
/// @param center  of the scene
glm::dvec3 findFocus(const Molecule& molecule, const PictureDescription& picture, const Seen& seen,
                     const glm::dvec3& center);

/// Focuses the lens of pictures at that place, unless its distance is given or there is no lens.
void focusLens(const Molecule& molecule, const PictureDescription& picture, const glm::dvec3& center,
               RenderSettings& settings);

}  // namespace nacre::app
