#include "tests/reference/compare_layers.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace nacre::reference {
namespace {

bool hasAllChannels(const Layers& layers) {
    const std::size_t pixels = layers.pixels();
    return layers.id.size() == pixels && layers.z.size() == pixels && layers.nx.size() == pixels &&
           layers.ny.size() == pixels && layers.nz.size() == pixels;
}

glm::dvec3 normalAt(const Layers& layers, std::size_t at) { return {layers.nx[at], layers.ny[at], layers.nz[at]}; }

/// Stable near 0 and 180, unlike the arc cosine of the dot product.
double angleDegrees(const glm::dvec3& a, const glm::dvec3& b) {
    const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / std::numbers::pi;
    // A zero vector has no direction; it must not pass for one that fits.
    return std::isfinite(angle) && glm::length(a) > 0.0 && glm::length(b) > 0.0 ? angle : 180.0;
}

double finiteOrInfinity(double error) { return std::isfinite(error) ? error : std::numeric_limits<double>::infinity(); }

double share(std::size_t part, std::size_t all) {
    return all == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(all);
}

/// Adds one pixel where both pictures show the same atom; returns its squared depth error.
double measureSurface(const Layers& reference, const Layers& drawn, std::size_t at, Comparison& result) {
    const double depth = finiteOrInfinity(std::abs(double{drawn.z[at]} - double{reference.z[at]}));
    if (depth > result.maxDepthError) {
        result.maxDepthError = depth;
        result.depthErrorAt = at;
    }
    const glm::dvec3 normal = normalAt(drawn, at);
    const double angle = angleDegrees(normalAt(reference, at), normal);
    if (angle > result.maxNormalAngle) {
        result.maxNormalAngle = angle;
        result.normalAngleAt = at;
    }
    const double length = finiteOrInfinity(std::abs(glm::length(normal) - 1.0));
    if (length > result.maxNormalLengthError) result.maxNormalLengthError = length;
    return depth * depth;
}

bool isCleanBackground(const Layers& layers, std::size_t at) {
    return layers.z[at] == std::numeric_limits<float>::infinity() && normalAt(layers, at) == glm::dvec3(0.0);
}

}  // namespace

double Comparison::silhouetteAgreement() const {
    return share(silhouetteJudged - silhouetteDisagrees, silhouetteJudged);
}

double Comparison::idAgreement() const { return share(idAgrees, idJudged); }

std::string Comparison::text() const {
    std::ostringstream out;
    out << pixels << " pixels, " << coveredInBoth << " covered in both (+" << coveredInReferenceOnly
        << " reference only, +" << coveredInDrawnOnly << " drawn only); silhouette agrees on "
        << 100.0 * silhouetteAgreement() << " % of " << silhouetteJudged << "; same atom on " << 100.0 * idAgreement()
        << " % of " << idJudged << " (" << nearEdge << " near an edge and " << ties
        << " ties left out); depth error max " << maxDepthError << ", rms " << rmsDepthError << " A; normal max "
        << maxNormalAngle << " degrees, length off by " << maxNormalLengthError << "; background faults "
        << backgroundFaults;
    return out.str();
}

Comparison compareLayers(const Layers& reference, const Layers& drawn, const CompareOptions& options) {
    if (reference.width != drawn.width || reference.height != drawn.height)
        throw std::invalid_argument("compareLayers: the pictures differ in size");
    if (!hasAllChannels(reference) || !hasAllChannels(drawn) || reference.gap.size() != reference.pixels() ||
        reference.nearEdge.size() != reference.pixels())
        throw std::invalid_argument("compareLayers: a channel is missing");

    Comparison result{.pixels = reference.pixels()};
    double squares = 0.0;
    for (std::uint32_t row = 0; row < reference.height; ++row)
        for (std::uint32_t column = 0; column < reference.width; ++column) {
            const std::size_t at = reference.index(column, row);
            const bool expected = reference.id[at] != 0, covered = drawn.id[at] != 0;
            if (!covered && !isCleanBackground(drawn, at)) ++result.backgroundFaults;
            if (expected && !covered) ++result.coveredInReferenceOnly;
            if (!expected && covered) ++result.coveredInDrawnOnly;

            const bool nearSilhouette = anyNeighbor(reference, column, row, [&](std::size_t neighbor) {
                return (reference.id[neighbor] != 0) != expected;
            });
            if (!nearSilhouette) {
                ++result.silhouetteJudged;
                if (expected != covered) ++result.silhouetteDisagrees;
            }
            if (!expected || !covered) continue;
            ++result.coveredInBoth;
            if (reference.nearEdge[at]) {
                ++result.nearEdge;
            } else if (reference.gap[at] < options.tieGap) {
                ++result.ties;
            } else {
                ++result.idJudged;
                if (reference.id[at] != drawn.id[at]) continue;
                ++result.idAgrees;
                squares += measureSurface(reference, drawn, at, result);
            }
        }
    if (result.idAgrees > 0) result.rmsDepthError = std::sqrt(squares / static_cast<double>(result.idAgrees));
    return result;
}

}  // namespace nacre::reference
