#pragma once
// The camera that an aim leads to.

#include <optional>

#include "app/picture/aim.h"
#include "app/picture/option_values.h"
#include "engine/molecule/residue_facts.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre::app {

struct Aimed {
    Camera camera;
    /// Å from the centre away from the viewer, where a plane cuts away most of what hides the target.
    std::optional<double> clipNear;
};

/// What is to be seen whole, if anything.
const std::optional<Selection>& uncoveredBy(const Aim& aim);

/// The camera, aimed. Its rotation in degrees is applied last, its zoom is that of what is zoomed to.
/// @throws Error if a selection has no drawn atom
Aimed aimed(const Camera& camera, const Aim& aim, const ResidueFacts& facts, const Representation& scene,
            const Size& size);

/// Room around what is zoomed to, Å: a ligand with what touches it.
constexpr double kZoomMargin = 3;

}  // namespace nacre::app
