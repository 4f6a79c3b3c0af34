#include "app/xr/eyes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace nacre::app {
namespace {

constexpr double kSame = 1e-6;  // runtimes give poses as floats

/// A point of the room in the eye's coordinates.
glm::dvec3 seenBy(const Pose& eye, const glm::dvec3& point) {
    return glm::conjugate(eye.orientation) * (point - eye.position);
}

/// Minimum depth of the centre for which a ball, with a margin, is entirely in front of the eye.
double leastDepth(const Placement& p) { return (1.02 * p.radius + 1.5) * p.metresPerAngstrom; }

bool mayShow(const Placement& p, const EyePose& eye) {
    const glm::dvec3 c = seenBy(eye, p.center);
    const double radius = p.radius * p.metresPerAngstrom;
    const auto beyond = [&](double across, double tangent) {  // beyond the plane through the eye and an edge
        return (across + c.z * tangent) / std::sqrt(1 + tangent * tangent) > radius;
    };
    return !beyond(c.x, eye.right) && !beyond(-c.x, -eye.left) && !beyond(c.y, eye.up) && !beyond(-c.y, -eye.down);
}

/// Whether the eyes look in parallel and are side by side. If so, makes their poses exactly parallel.
bool straighten(std::array<EyePose, 2>& eyes) {
    auto& [left, right] = eyes;
    const glm::dvec3 between = seenBy(left, right.position);
    const bool parallel = std::abs(glm::dot(left.orientation, right.orientation)) > 1 - kSame * kSame;
    if (!parallel || std::abs(between.y) > kSame || std::abs(between.z) > kSame) return false;
    right.orientation = left.orientation;
    right.position = left.position + left.orientation * glm::dvec3(between.x, 0, 0);
    return true;
}

/// Sets an interval to this length about its middle. @returns the middle
double widen(double& low, double& high, double length) {
    const double middle = (low + high) / 2;
    low = middle - length / 2, high = middle + length / 2;
    return middle;
}

}  // namespace

Placement keepInFront(Placement& placement, const std::array<EyePose, 2>& eyes) {
    const auto shows = [&](const EyePose& eye) { return mayShow(placement, eye); };
    if (std::ranges::none_of(eyes, shows)) {
        constexpr double kFarBeside = 1000;  // relative to the depth
        Placement beside = placement;
        const double depth = 2 * leastDepth(placement);
        beside.center = eyes[0].position + eyes[0].orientation * glm::dvec3(kFarBeside * depth, 0, -depth);
        return beside;
    }
    for (const EyePose& eye : eyes) {
        const double missing = leastDepth(placement) + seenBy(eye, placement.center).z;
        if (missing > 0) placement.center += eye.orientation * glm::dvec3(0, 0, -missing);
    }
    return placement;
}

EyeViews makeViews(const Placement& placement, std::array<EyePose, 2> eyes, std::uint32_t width, std::uint32_t height) {
    const bool parallel = straighten(eyes);
    double pixels = INFINITY;  // per unit of tangent
    for (const EyePose& eye : eyes)
        pixels = std::min({pixels, width / (eye.right - eye.left), height / (eye.up - eye.down)});
    EyeViews seen{{}, eyes};
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        EyePose& eye = seen.eyes[i];
        const double across = widen(eye.left, eye.right, width / pixels), up = widen(eye.down, eye.up, height / pixels);
        glm::dvec3 center = seenBy(eye, placement.center) / placement.metresPerAngstrom;
        if (parallel && i > 0) {  // the difference is only rounding
            center.y = seen.views[0].shift.y;
            center.z = -seen.views[0].eyeDistance;
        }
        View& view = seen.views[i];
        view.width = width, view.height = height;
        view.projection = Projection::perspective;
        view.radius = placement.radius;
        view.rotation = glm::mat3_cast(glm::conjugate(eye.orientation)) * placement.rotation;
        view.eyeDistance = -center.z;
        view.shift = {center.x, center.y, 0};
        view.pixelsPerAngstrom = pixels / view.eyeDistance;
        view.pan = -glm::dvec2(across, up) * view.eyeDistance;
    }
    return seen;
}

Grip::Grip(const Pose& hand, const glm::dvec3& head, const glm::dquat& orientation, double zoom)
    : turned_(glm::conjugate(hand.orientation) * orientation),
      head_(head),
      away_(glm::distance(hand.position, head)),
      zoom_(zoom) {}

double Grip::zoom(const Pose& hand) const {
    constexpr double kSmallest = 0.1, kLargest = 4;
    const double nearer = away_ - glm::distance(hand.position, head_);
    return std::clamp(zoom_ * std::exp2(nearer / kMetresPerDouble), std::min(kSmallest, zoom_),
                      std::max(kLargest, zoom_));
}

}  // namespace nacre::app
