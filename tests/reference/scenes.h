#pragma once
// Scenes and views made by hand for the tests of the reference renderers.

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre::reference {

inline void addSphere(Representation& scene, const glm::vec3& center, float radius, std::uint32_t atom) {
    scene.spheres.push_back({center, radius});
    scene.sphereLooks.push_back({0xffffffffu, atom});
    const double reach = glm::length(glm::dvec3(center)) + radius;
    if (reach > scene.radius) scene.radius = reach;
}

inline void addRod(Representation& scene, const glm::vec3& a, const glm::vec3& b, float radius, std::uint32_t atomA,
                   std::uint32_t atomB) {
    scene.cylinders.push_back({a, radius, b});
    scene.cylinderLooks.push_back({0xffffffffu, 0xffffffffu, atomA, atomB});
    for (const glm::vec3& end : {a, b}) {
        const double reach = glm::length(glm::dvec3(end)) + radius;
        if (reach > scene.radius) scene.radius = reach;
    }
}

inline View viewOfScene(const Representation& scene, Projection projection, std::uint32_t width, std::uint32_t height,
                        const glm::dvec3& rotationDegrees = {}, double zoom = 1.0) {
    Camera camera{.projection = projection, .rotationDegrees = rotationDegrees, .zoom = zoom};
    return makeView(camera, scene.radius, width, height);
}

}  // namespace nacre::reference
