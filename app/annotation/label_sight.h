#pragma once
// Whether what a label names is seen, or lies behind other atoms.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/effects.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre::app {

/// Everything that a scene draws, as something that hides.
class LabelSight {
public:
    explicit LabelSight(const Representation& scene);

    /// Rays from the viewer's side of each of some atoms to the viewer are asked whether anything stands in their way
    /// but their own residues.
    struct Named {
        std::vector<std::uint32_t> atoms;  ///< that do not hide it, as looks number them, ascending
        std::vector<glm::dvec3> places;    ///< of some of them, Å from the scene's centre
        std::vector<double> radii;         ///< of these
    };
    /// The share of what each of them shows that nothing hides, 0..1.
    /// @param clip  what it cuts away hides nothing, judged by its middle
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
    std::vector<Ball> balls_;  ///< atoms; sticks as rows of balls
    std::vector<Facet> facets_;
};

}  // namespace nacre::app
