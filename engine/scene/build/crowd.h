#pragma once

namespace nacre {

struct Representation;

/// Limits how often primitives cover the picture, which decides the time: a large protein covers it about twenty times,
/// a thousand models of a small one three thousand times. A small file with all atoms at one point must not run for
/// hours; at the limit a picture takes lavapipe a minute of CPU time, and so does a bake.
/// @throws Error beyond 10,000 times
void refuseCrowd(const Representation& representation);

}  // namespace nacre
