#pragma once
// Scenes of the self-test, and what their pictures must show, found by casting rays without the renderer's arithmetic.

#include <vector>

#include "engine/results.h"
#include "engine/scene/build/representation.h"
#include "engine/settings.h"

namespace nacre {

/// A scene whose picture by a correct path matches its rays.
struct TestScene {
    enum class Shows {
        colors,     ///< the colour of the nearest surface
        occlusion,  ///< as above, and then the darkness of a bake
    };
    Representation representation;
    Projection projection{};
    Shows shows{};
};

/// Spheres and sticks; intersecting spheres, which plates alone cannot settle; intersecting triangles; and all kinds in
/// perspective. Each atom has its own colour.
std::vector<TestScene> selfTestScenes();

/// A scene to time: its first frames are a warm-up.
struct TimedScene {
    Representation representation;
    Projection projection{};
};
/// Scenes of three sizes: a few large spheres, some thousand triangles in perspective, and many small spheres.
std::vector<TimedScene> timedScenes();

/// Settings to test a scene: they show unshaded colours.
RenderSettings testSettings(const Representation& representation, Projection projection, std::uint32_t pixels);

/// Whether a picture shows the scene. Pixels near an edge may show either side.
bool shows(const Picture& picture, const Representation& representation, const View& view);

/// Whether a picture of spheres is as dark as its occlusion requires. Tests a bake: draws, dispatches and copies.
/// Orthographic. @param directions  of the bake
bool showsOcclusion(const Picture& picture, const Representation& representation, const View& view, int directions);

}  // namespace nacre
