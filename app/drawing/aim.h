#pragma once
// The camera that results from an aim.

#include <optional>

#include "app/picture/aim.h"
#include "app/picture/option_values.h"
#include "engine/molecule/residue_facts.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre::app {

struct Aimed {
    Camera camera;
    /// Å from the centre away from the viewer: a clipping plane that removes most of what hides the target.
    std::optional<double> clipNear{};
    std::optional<double> clipBefore{};  ///< Å, likewise: a plane in front of Aim::clip
    double depth = 0;                    ///< Å, likewise: the zoom target's centre, from which planes count
};

/// The selection to uncover, if any.
const std::optional<Selection>& uncoveredBy(const Aim& aim);

/// The scene that an aim refers to.
struct AimScene {
    const Representation& scene;
    double radius = 0;                       ///< that the camera frames, Å
    const Representation* beside = nullptr;  ///< maps and primitives about the same centre, for fitting only
};

/// The camera after aiming. Applies its rotation (degrees) last; its zoom is relative to the zoom target.
/// @throws Error if a selection has no drawn atom
Aimed aimed(const Camera& camera, const Aim& aim, const ResidueFacts& facts, const AimScene& shown, const Size& size);

/// Margin around a zoom target, Å: a ligand with its contacts.
constexpr double kZoomMargin = 3;

}  // namespace nacre::app
