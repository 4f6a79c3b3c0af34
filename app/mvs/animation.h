#pragma once
// Animations of snapshots: parameters of nodes that change with time.

#include <optional>
#include <string>
#include <string_view>

#include "app/mvs/scene_parts.h"

namespace nacre::app::mvs {

/// Maps 0..1 to 0..1 with fixed ends, by the name of an easing ("cubic-in-out"); empty: unknown name.
std::optional<double> easedByName(std::string_view easing, double time);

/// The camera's transition to a snapshot.
struct CameraTransition {
    double seconds = 0;
    std::string easing = "linear", trajectory = "linear";
};
CameraTransition readTransition(const Node& transition);
/// The transition to a snapshot; empty: it has no such node.
std::optional<CameraTransition> transitionTo(const Snapshot& snapshot);

/// Duration of a snapshot's animation, seconds, an hour at most; 0: it has none.
double animationSeconds(const Snapshot& snapshot);
/// A boolean parameter of the animation.
bool animationFlag(const Snapshot& snapshot, const char* name);

/// The snapshot at a time of its animation. @param seconds  from the animation's start
Snapshot animatedAt(const Snapshot& snapshot, double seconds, SceneWarnings& warnings);

}  // namespace nacre::app::mvs
