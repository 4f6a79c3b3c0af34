#pragma once

#include <functional>

#include "app/drawing/map_layers.h"
#include "engine/scene/build/representation.h"

namespace nacre::app {

/// The scene of a description with moving atoms: selection and colours are fixed, positions change. Surfaces coloured
/// by a map keep the range of the first positions.
class MovingPicture {
public:
    using Recolor = std::function<void(Representation&)>;
    /// @param recolor  colours each scene before a map does; may be empty @throws Error if the scene is empty
    MovingPicture(const ResidueFacts& facts, const PictureDescription& picture, Recolor recolor = {});

    /// Radius of the first positions, or of all models of the file if they share a camera, Å.
    double radius() const { return radius_; }
    /// @param molecule  the same molecule with other positions @throws Error
    Representation moved(const Molecule& molecule);

private:
    MovingScene scene_;
    double radius_;
    Recolor recolor_;
    SurfaceColoring surfaces_;
};

}  // namespace nacre::app
