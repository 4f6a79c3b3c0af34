#pragma once

namespace nacre {

struct Representation;

/// Time goes with how often the picture is covered over and over: a large protein covers it some twenty times, a
/// thousand models of a small one three thousand times. A file of atoms at one point, however small, must not run for
/// hours; at this bound a picture takes lavapipe a minute of processor time, and a bake as much.
/// @throws Error beyond 10,000 times
void refuseCrowd(const Representation& representation);

}  // namespace nacre
