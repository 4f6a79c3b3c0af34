#pragma once
// Primitives as JSON (docs/geometry.md).

#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "app/picture/geometry_options.h"
#include "engine/molecule/molecule.h"
#include "engine/scene/build/primitives.h"

namespace nacre::app {

/// Position of a point given as text, Å. @throws Error
using FindPlace = std::function<glm::dvec3(const std::string& selection)>;

/// @param name  of the file, for errors @throws Error naming the primitive and its key
/// @param file  has the unit cell or periodic box for the kind "cell"
Primitives readPrimitives(const std::string& json, const std::string& name, const FindPlace& findPlace,
                          const FileSummary& file = {});

/// All primitives of a picture. Points that are selections are the mean of their atoms. @throws Error
Primitives loadPrimitives(const std::vector<PrimitiveSource>& sources, const Molecule& molecule);

}  // namespace nacre::app
