#include "app/viewer/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace nacre::app {
namespace {

/// Points per Å on the plane through the molecule's centre.
double pointsPerAngstrom(const Camera& camera, double radius, const Viewport& viewport) {
    constexpr std::uint32_t kUnit = 1000;  // of a square window; the scale is proportional to its side
    const View view = makeView(camera, radius, kUnit, kUnit);
    return view.pixelsPerAngstrom * std::min(viewport.width, viewport.height) / kUnit;
}

/// Points from the window's middle, y up.
glm::dvec2 fromMiddle(glm::dvec2 at, const Viewport& viewport) {
    return {at.x - viewport.width / 2, viewport.height / 2 - at.y};
}

/// From 0 to 1 with zero slope at both ends.
double eased(double t) { return t * t * (3 - 2 * t); }

}  // namespace

void CameraMotion::set(const Camera& camera) {
    camera_ = camera;
    // Stores one rotation, which can be rotated further.
    camera_.orientation = glm::normalize(glm::quat_cast(rotationMatrix(camera.rotationDegrees)) * camera.orientation);
    camera_.rotationDegrees = glm::dvec3(0);
    touch();
}

void CameraMotion::turn(glm::dvec2 points) {
    const double length = glm::length(points);
    if (length == 0) return;
    const glm::dvec3 axis(points.y / length, points.x / length, 0);
    const glm::dquat by = glm::angleAxis(glm::radians(length * kDegreesPerPoint), axis);
    camera_.orientation = glm::normalize(by * camera_.orientation);
}

void CameraMotion::rotate(glm::dvec2 points, double now) {
    turn(points);
    // Averages the speed over this time: single steps of a drag are uneven.
    constexpr double kWindow = 0.05;
    const double passed = std::max(now - lastDrag_, 1e-3);
    const double keep = std::exp(-passed / kWindow);
    velocity_ = velocity_ * keep + points / passed * (1 - keep);
    lastDrag_ = now;
}

void CameraMotion::hold(const glm::dquat& orientation, double zoom) {
    touch();
    camera_.orientation = glm::normalize(orientation);
    camera_.zoom = zoom;
}

void CameraMotion::roll(double radians) {
    camera_.orientation = glm::normalize(glm::angleAxis(-radians, glm::dvec3(0, 0, 1)) * camera_.orientation);
    // The picture rotates about its centre, including its pan.
    const double c = std::cos(radians), s = std::sin(radians);
    camera_.pan = {c * camera_.pan.x + s * camera_.pan.y, c * camera_.pan.y - s * camera_.pan.x};
}

void CameraMotion::pan(glm::dvec2 points, double radius, const Viewport& viewport) {
    camera_.pan += glm::dvec2(points.x, -points.y) / pointsPerAngstrom(camera_, radius, viewport);
    // Keeps at least the molecule's rim within reach.
    const double reach =
        radius + std::max(viewport.width, viewport.height) / 2 / pointsPerAngstrom(camera_, radius, viewport);
    camera_.pan = glm::clamp(camera_.pan, glm::dvec2(-reach), glm::dvec2(reach));
}

void CameraMotion::zoom(double factor, glm::dvec2 at, double radius, const Viewport& viewport) {
    const glm::dvec2 place = fromMiddle(at, viewport);
    const double before = pointsPerAngstrom(camera_, radius, viewport);
    camera_.zoom = std::clamp(camera_.zoom * factor, 0.05, 1000.0);
    const double after = pointsPerAngstrom(camera_, radius, viewport);
    camera_.pan += place / after - place / before;
    if (camera_.zoom < 1) camera_.pan *= std::min(1.0, after / before);  // small molecules drift to the middle
}

void CameraMotion::touch() {
    autoRotation_ = gliding_ = rocking_ = false;
    flight_.reset();
    velocity_ = {};
}

void CameraMotion::release(double now) {
    constexpr double kPause = 0.1;  // a pause before release cancels inertia
    gliding_ = now - lastDrag_ < kPause && glm::length(velocity_) > kStillPointsPerSecond;
    lastAdvance_ = now;
}

void CameraMotion::fly(const Camera& to, double now, double seconds) {
    touch();
    flight_ = Flight{camera_, to, now, seconds};
}

void CameraMotion::fit(double now) {
    Camera to = camera_;
    to.pan = {};
    to.zoom = 1;
    fly(to, now);
}

void CameraMotion::reset(double now) {
    fly(Camera{.projection = camera_.projection, .fovDegrees = camera_.fovDegrees, .center = camera_.center}, now);
}

void CameraMotion::setRocking(bool on) {
    rocking_ = on;
    swing_ = 0;
}

bool CameraMotion::advance(double now) {
    const double passed = lastAdvance_ ? std::max(now - *lastAdvance_, 0.0) : 0.0;
    lastAdvance_ = now;
    if (flight_) {
        const double t = eased(std::clamp((now - flight_->start) / flight_->seconds, 0.0, 1.0));
        const Camera &a = flight_->from, &b = flight_->to;
        camera_.orientation = glm::normalize(glm::slerp(a.orientation, b.orientation, t));
        camera_.pan = glm::mix(a.pan, b.pan, t);
        camera_.zoom = std::exp(glm::mix(std::log(a.zoom), std::log(b.zoom), t));
        if (t == 1.0) {
            camera_ = b;
            flight_.reset();
        }
        return true;
    }
    if (autoRotation_) {
        turn({kAutoDegreesPerSecond / kDegreesPerPoint * passed, 0});
        return true;
    }
    if (rocking_) {
        const auto angle = [](double time) { return kRockDegrees * std::sin(glm::radians(360 * time / kRockSeconds)); };
        turn({(angle(swing_ + passed) - angle(swing_)) / kDegreesPerPoint, 0});
        swing_ = std::fmod(swing_ + passed, kRockSeconds);
        return true;
    }
    if (!gliding_) return false;
    // The exact integral of an exponential decay: independent of step size.
    const double keep = std::exp(-passed / kInertiaSeconds);
    turn(velocity_ * kInertiaSeconds * (1 - keep));
    velocity_ *= keep;
    gliding_ = glm::length(velocity_) > kStillPointsPerSecond;
    return true;
}

}  // namespace nacre::app
