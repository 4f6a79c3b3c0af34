#pragma once
// Converts a headset's poses to the views of its eyes. Metres in the room: +x right, +y up, +z towards the viewer.

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/scene/view/camera.h"

namespace nacre::app {

struct Pose {
    glm::dvec3 position{0};
    glm::dquat orientation{1, 0, 0, 0};
};

/// The eye looks along its -z. Tangents of the angles to its picture's edges; left and down are usually negative.
struct EyePose : Pose {
    double left = -1, right = 1, down = -1, up = 1;
};

/// Placement of a molecule in the room.
struct Placement {
    glm::dvec3 center{0};      ///< of the scene
    glm::dmat3 rotation{1.0};  ///< from scene to room
    double metresPerAngstrom = 1;
    double radius = 1;  ///< of the scene, Å
};

struct EyeViews {
    std::array<View, 2> views;
    /// The eyes as drawn. Pixels are square, so a picture may be wider or taller than requested.
    std::array<EyePose, 2> eyes;
};

/// If a molecule is in sight, moves it away from the eyes along their axes until all of it is in front of both.
/// @returns the placement; of a molecule out of sight, one far beside both pictures
Placement keepInFront(Placement& placement, const std::array<EyePose, 2>& eyes);

/// @param placement  in front of both eyes @param width, height  of each eye's picture, pixels
EyeViews makeViews(const Placement& placement, std::array<EyePose, 2> eyes, std::uint32_t width, std::uint32_t height);

/// Rotates and scales the molecule with the hand that holds it.
class Grip {
public:
    static constexpr double kMetresPerDouble = 0.2;  ///< pulling this far towards the head doubles the size

    /// @param head  pulling the hand towards it enlarges @param zoom  current zoom of the molecule
    Grip(const Pose& hand, const glm::dvec3& head, const glm::dquat& orientation, double zoom);

    glm::dquat orientation(const Pose& hand) const { return hand.orientation * turned_; }
    double zoom(const Pose& hand) const;

private:
    glm::dquat turned_;  // orientation of the molecule relative to the hand
    glm::dvec3 head_;
    double away_, zoom_;
};

}  // namespace nacre::app
