#pragma once
// The point that a camera looks at; maps are drawn around it.

#include <glm/vec3.hpp>

#include "app/picture/description.h"
#include "engine/molecule/molecule.h"
#include "engine/settings.h"

namespace nacre::app {

/// A camera after aiming, and the radius that it frames (Å).
struct Seen {
    Camera camera;
    double radius = 0;
};

/// The point in the picture's middle, Å in the file's frame. Its depth is that of the target of --zoom-to or --uncover;
/// else of the nearest visible atom within 2 Å of the line of sight; else of the atom closest to that line.
/// @param center  of the scene
glm::dvec3 findFocus(const Molecule& molecule, const PictureDescription& picture, const Seen& seen,
                     const glm::dvec3& center);

/// Focuses the lens of pictures on that point, unless its distance is given or there is no lens.
void focusLens(const Molecule& molecule, const PictureDescription& picture, const glm::dvec3& center,
               RenderSettings& settings);

}  // namespace nacre::app
