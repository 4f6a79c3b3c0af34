#pragma once
// Whether a label's atoms are visible or hidden behind others.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/effects.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre::app {

/// Everything that a scene draws, as occluders.
class LabelSight {
public:
    explicit LabelSight(const Representation& scene);

    /// Casts rays from the viewer's side of sample atoms to the viewer. Their own residues do not occlude.
    struct Named {
        std::vector<std::uint32_t> atoms;  ///< atoms that do not occlude it, numbered as in looks, ascending
        std::vector<glm::dvec3> places;    ///< of sample atoms, Å from the scene's centre
        std::vector<double> radii;         ///< of these
    };
    /// The visible fraction of each, 0..1. @param clip  atoms whose centre it clips do not occlude
    std::vector<double> openShares(const std::vector<const Named*>& named, const View& view, const Clip& clip) const;

private:
    struct Ball {
        glm::vec3 center;
        float radius;
        std::uint32_t atom;
    };
    struct Facet {
        glm::vec3 a, b, c;
        std::uint32_t atom;
    };
    std::vector<Ball> balls_;  ///< atoms, and sticks as rows of balls
    std::vector<Facet> facets_;
};

}  // namespace nacre::app
