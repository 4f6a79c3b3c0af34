#pragma once
// Scenes with clefts, and the light of their pictures against paths that bounce from surface to surface.

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/renderer.h"
#include "engine/scene/build/representation.h"
#include "tests/reference/path_tracer.h"

namespace nacre::test {

/// A scene, and one view of it with one sample per pixel.
struct Lit {
    Representation scene;
    RenderSettings settings;
};

/// A ball in a shell of others, seen through a hole: hardly any direction reaches it.
Lit well();
Lit dna();
Lit dnaCartoon();
/// About the drug of 1HPV, in the depth of the protease.
Lit pocket(ColorScheme colors);
/// 4HHB.
Lit hemoglobin(ColorScheme colors);

/// Light from all sides alone.
Light ambientAlone();
/// The sky of shaders/common/shading.glsl.
reference::Sky sky();

/// Random pixels of a view, and the light that paths say leaves them towards the viewer.
struct TracedLight {
    std::vector<std::uint32_t> pixels;
    std::vector<glm::dvec3> light;
};
/// @param layers  of the view @param paths  per pixel
TracedLight traceLight(const Lit& lit, const LayerPicture& layers, const reference::Sky& sky, std::size_t pixels = 1000,
                       std::size_t paths = 256);

class SquaredErrors {
public:
    void add(double difference) {
        sum_ += difference * difference;
        ++count_;
    }
    double rms() const { return std::sqrt(sum_ / static_cast<double>(count_)); }

private:
    double sum_ = 0;
    std::size_t count_ = 0;
};
/// Root mean square of what a picture shows less what paths find. @param rgba  linear
double lightError(const std::vector<float>& rgba, const TracedLight& truth);

}  // namespace nacre::test
