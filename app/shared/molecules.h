#pragma once
// From a name to a molecule and its scene, as far as no network is needed.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "app/shared/input_options.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre::app {

/// A part of the machine's memory, in bytes. @param parts  how many such parts there are
std::uint64_t memoryShare(unsigned parts);

/// Reads a sample, a file or standard input, whatever else `input.path` looks like.
/// @param bytes     what the molecule may take
/// @param readFile  gives a file's bytes, where a path alone does not open it
/// @param onModel   of all models of a file: called after each with the share that is read, 0..1
/// @throws Error
Molecule readLocally(const InputOptions& input, std::uint64_t bytes,
                     const std::function<std::string(const std::string&)>& readFile = {},
                     const std::function<void(double)>& onModel = {});

/// What is drawn of a molecule, in its style and colours. @throws Error if that is nothing
/// @param frame  that all models of its file share (shared_frame.h), if that is known; else it is found, if it can be
Representation sceneOf(const Molecule& molecule, const std::string& name, const DrawnAtomsOptions& drawn,
                       const RepresentationOptions& look, const std::optional<Bounds>& frame = {});

/// The same of one whose atoms move; seen as all models of its file are, if it has others. @throws Error
MovingScene movingSceneOf(const Molecule& molecule, const std::string& name, const DrawnAtomsOptions& drawn,
                          const RepresentationOptions& look);

/// Atoms that moved may reach farther than what a view goes by: it sees them all, from where it is.
/// @param radius  that holds them, Å
inline void reachTo(View& view, double radius) {
    constexpr double kNearest = 1.02;  // of it, to the eye
    view.radius = radius;
    if (view.projection == Projection::perspective) view.eyeDistance = std::max(view.eyeDistance, radius * kNearest);
}

}  // namespace nacre::app
