#pragma once
// Levels of detail for spheres with many copies: clusters of atoms, from residues to domains in size.

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre {

/// One level: each sphere represents an atom, or as many neighbours as the error allows.
struct SphereLevel {
    std::uint32_t first = 0, count = 0;  ///< of SphereLevels::spheres; `first` is a multiple of kSpheres
    std::uint32_t step = 0;              ///< of SphereLevels::levelError()
};

/// Spheres with the same copies.
struct LeveledPart {
    glm::vec3 center{};  ///< centre of a ball around all levels, as stored
    float radius = 0;
    std::uint32_t list = 0;           ///< of Copies::lists
    std::vector<SphereLevel> levels;  ///< finest first: the atoms themselves
};

struct SphereLevels {
    static constexpr std::uint32_t kSpheres = 32;  ///< per ball

    /// Bounds of spheres 32 i to 32 i + 31.
    struct Ball {
        glm::vec3 center{};
        float radius = 0;
    };

    /// Largest difference between the outlines of a level and of the atoms, Å; grows by half with every step.
    static float levelError(std::uint32_t step) {
        return step == 0 ? 0 : 0.35f * std::exp2(0.5f * static_cast<float>(step - 1));
    }

    std::vector<Sphere> spheres;  ///< of all levels, neighbours in space next to each other
    std::vector<SphereLook>
        looks;  ///< same length; a cluster has the atoms' mean colour, and the number of a visible one
    std::vector<Ball> balls;
    std::vector<LeveledPart> parts;
};

/// Number of spheres in all copies.
std::uint64_t spheresInCopies(const Representation& representation);

/// Whether each primitive of each copy has a number below 2^32, as shaders require.
bool hasNumbers(const Representation& representation);

/// Whether a scene consists only of copies of spheres, which levels can replace.
bool canHaveLevels(const Representation& representation);

/// Builds levels once per part, not per copy.
SphereLevels makeSphereLevels(const Representation& representation);

}  // namespace nacre
