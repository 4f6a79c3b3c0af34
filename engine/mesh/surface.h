#pragma once
// Molecular surfaces: solvent-excluded and Gaussian. Knows no Vulkan.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "engine/mesh/mesh.h"
#include "engine/molecule/molecule.h"

namespace nacre {

enum class SurfaceKind : std::uint8_t {
    solventExcluded,    ///< what a ball of the probe's size cannot enter (Richards 1977, Connolly 1983)
    solventAccessible,  ///< where the probe's centre goes: every atom larger by its radius (Lee and Richards 1971)
    gaussian            ///< where sum exp(-s d^2 / r^2) = exp(-s), s = 1.5 (as in Mol*): an atom alone has its radius
};

struct SurfaceOptions {
    SurfaceKind kind = SurfaceKind::solventExcluded;
    double probe = 1.4;     ///< Å, radius; 0 is the van der Waals surface
    double resolution = 0;  ///< Å, edge of the grid's cells; 0: surfaceResolution() of the atoms
    bool cavities = true;   ///< surfaces that are closed off from the outside are kept
    friend bool operator==(const SurfaceOptions&, const SurfaceOptions&) = default;
};

constexpr double kFinestSurface = 0.1, kCoarsestSurface = 1.2;  ///< Å, bounds of SurfaceOptions::resolution
constexpr double kLargestProbe = 10;                            ///< Å
constexpr std::size_t kMostSurfaceTriangles = 20'000'000;

/// The resolution that a number of atoms is given: about 1.5 million triangles, but neither finer than 0.4 Å nor
/// coarser than 1.2 Å.
double surfaceResolution(std::size_t atoms);

/// The surface of some atoms, with van der Waals radii by element; those that are not finite are left out. One closed
/// mesh of which each vertex lies on the surface itself and has its normal, and belongs to the atom whose own sphere is
/// nearest. Marching cubes; where a distance is asked for it is that to the nearest place of the probe's centre among
/// spheres, circles and points that are worked out exactly, not to the next of the grid's cells. The grid is made in
/// blocks, by several threads, so that memory goes with the surface. The same atoms give the same mesh, whatever the
/// number of threads.
/// @param atoms  indices of atoms, ascending
/// @param origin  what the positions are relative to, Å, in the file's frame
/// @return empty without atoms
/// @throws Error if the mesh would be too large: over kMostSurfaceTriangles
Mesh surface(const Molecule& molecule, std::span<const std::uint32_t> atoms, const SurfaceOptions& options,
             const glm::dvec3& origin);

}  // namespace nacre
