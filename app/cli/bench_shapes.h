#pragma once
// What `nacre bench` says about the shapes that spheres are drawn in.

#include <iosfwd>

#include "app/cli/bench_frames.h"

namespace nacre::app {

/// Shaded fragments of each pass of the encoded path, and its frame times, for every shape of plates and impostors.
/// @param encoded  draws by that path @returns a row for each pair of shapes
Json compareShapes(const BenchOptions& options, const Representation& scene, Renderer& encoded, Progress& progress);

/// The rows of compareShapes as a table.
void printShapes(const Json& shapes, std::ostream& out);

}  // namespace nacre::app
