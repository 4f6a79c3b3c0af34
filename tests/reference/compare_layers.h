#pragma once
// Holds a drawn picture against the ray caster's.

#include <cstddef>
#include <string>

#include "tests/reference/layers.h"

namespace nacre::reference {

struct CompareOptions {
    /// Two surfaces closer than this, in Å, may win either way: the step of a float at 100 Å is 8e-6 Å, and a depth
    /// is the outcome of a dozen such roundings.
    double tieGap = 1e-4;
};

/// Counts of pixels. "Edge" always means one of the reference's, and "near" one of the eight neighbours.
struct Comparison {
    std::size_t pixels = 0;
    std::size_t coveredInBoth = 0;
    std::size_t coveredInReferenceOnly = 0, coveredInDrawnOnly = 0;  ///< anywhere

    std::size_t silhouetteJudged = 0;     ///< not near an edge between cover and background
    std::size_t silhouetteDisagrees = 0;  ///< of those judged, covered in one picture only

    std::size_t nearEdge = 0;  ///< covered in both, left out: another atom or background is next to it
    std::size_t ties = 0;      ///< covered in both, not near an edge, left out: two surfaces within tieGap
    std::size_t idJudged = 0;  ///< covered in both, less those two
    std::size_t idAgrees = 0;  ///< of those judged, the same atom is front-most

    // Over the pixels that idAgrees counts. Infinite, or 180 degrees, where the drawn number is not finite.
    double maxDepthError = 0.0, rmsDepthError = 0.0;  ///< Å
    double maxNormalAngle = 0.0;                      ///< degrees
    double maxNormalLengthError = 0.0;                ///< | |N| - 1 | of the drawn normals
    std::size_t depthErrorAt = 0, normalAngleAt = 0;  ///< pixel index of the maxima

    std::size_t backgroundFaults = 0;  ///< drawn id 0 whose Z is not +infinity or whose N is not 0, anywhere

    double silhouetteAgreement() const;  ///< share of those judged, 0..1; 1 if none
    double idAgreement() const;          ///< share of those judged, 0..1; 1 if none
    /// One line that names every figure, for messages of tests and tables.
    std::string text() const;
};

/// @param reference  of castRays
/// @param drawn      the GPU's; its id, z, nx, ny, nz are read
/// @throws std::invalid_argument if the sizes differ or a channel is missing
Comparison compareLayers(const Layers& reference, const Layers& drawn, const CompareOptions& options = {});

}  // namespace nacre::reference
