#pragma once
// Levels of detail of spheres that have many copies: clusters of atoms, about as large as residues, then as domains.

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre {

/// One level: its spheres stand for atoms, or for as many neighbours as its error allows.
struct SphereLevel {
    std::uint32_t first = 0, count = 0;  ///< of SphereLevels::spheres; `first` is a multiple of kSpheres
    std::uint32_t step = 0;              ///< of SphereLevels::errorOf(), in Å
};

/// Spheres with the same copies.
struct LeveledPart {
    glm::vec3 center{};  ///< of a ball about all levels, as stored
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

    /// Å by which the outline of a level may differ from that of the atoms: by half as much again with every step.
    static float errorOf(std::uint32_t step) {
        return step == 0 ? 0 : 0.35f * std::exp2(0.5f * static_cast<float>(step - 1));
    }

    std::vector<Sphere> spheres;  ///< of all levels, neighbours in space next to each other
    std::vector<SphereLook>
        looks;  ///< same length; a cluster has the atoms' mean colour, and the number of one that is seen
    std::vector<Ball> balls;
    std::vector<LeveledPart> parts;
};

/// Counted in all copies.
std::uint64_t spheresInCopies(const Representation& representation);

/// Whether each primitive of each copy has a number below 2^32, by which shaders know it.
bool hasNumbers(const Representation& representation);

/// Whether a scene consists of copies of spheres alone, which levels can stand for.
bool canHaveLevels(const Representation& representation);

/// Built once for each part, not for its copies.
SphereLevels sphereLevelsOf(const Representation& representation);

}  // namespace nacre
