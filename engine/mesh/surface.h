#pragma once
// Molecular surfaces: solvent-excluded, solvent-accessible and Gaussian. Makes no Vulkan calls.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "engine/mesh/mesh.h"
#include "engine/molecule/element.h"
#include "engine/molecule/molecule.h"

namespace nacre {

enum class SurfaceKind : std::uint8_t {
    solventExcluded,    ///< the region that a probe cannot enter (Richards 1977, Connolly 1983)
    solventAccessible,  ///< the surface of the probe's centre: every atom enlarged by its radius (Lee and Richards
                        ///< 1971)
    gaussian            ///< where sum exp(-s d^2 / r^2) = exp(-s), s = 1.5 (as in Mol*): a single atom has its radius
};

struct SurfaceOptions {
    SurfaceKind kind = SurfaceKind::solventExcluded;
    double probe = 1.4;     ///< radius, Å; 0: the van der Waals surface
    double resolution = 0;  ///< edge of the grid's cells, Å; 0: surfaceResolution() of the atoms
    bool cavities = true;   ///< keep closed cavities
    double scale = 1;       ///< of the atoms' radii
    float (*radius)(Element) = vanDerWaalsRadius;
    friend bool operator==(const SurfaceOptions&, const SurfaceOptions&) = default;
};

constexpr double kFinestSurface = 0.1, kCoarsestSurface = 1.2;  ///< bounds of SurfaceOptions::resolution, Å
constexpr double kLargestProbe = 10;                            ///< Å
constexpr std::size_t kMostSurfaceTriangles = 20'000'000;

/// Default resolution for a number of atoms: about 1.5 million triangles, within 0.4 to 1.2 Å.
double surfaceResolution(std::size_t atoms, SurfaceKind kind);

/// The surface of some atoms, with van der Waals radii by element; ignores non-finite positions. One closed mesh: each
/// vertex lies on the exact surface with its exact normal, and belongs to the atom whose sphere is nearest. Marching
/// cubes on exact distances to the nearest possible probe centre (spheres, circles and points in closed form), not on
/// distances between grid cells. The grid is processed in blocks, by several threads, so that memory is proportional to
/// the surface. The result does not depend on the number of threads.
/// @param atoms  indices of atoms, ascending
/// @param origin  of the positions, Å, in the file's frame
/// @return empty without atoms
/// @throws Error if the mesh would be too large: over kMostSurfaceTriangles
Mesh surface(const Molecule& molecule, std::span<const std::uint32_t> atoms, const SurfaceOptions& options,
             const glm::dvec3& origin);

}  // namespace nacre
