#pragma once
// Interactive camera: a trackball with inertia, automatic rotation, and short flights to another view.

#include <glm/vec2.hpp>
#include <optional>

#include "engine/scene/view/camera.h"

namespace nacre::app {

/// The window, in points.
struct Viewport {
    double width = 1, height = 1;
};

class CameraMotion {
public:
    static constexpr double kDegreesPerPoint = 1.0;
    static constexpr double kAutoDegreesPerSecond = 30.0;
    static constexpr double kRockDegrees = 20, kRockSeconds = 4;  ///< to either side; one full cycle
    static constexpr double kInertiaSeconds = 0.325;              ///< a released rotation slows down to 1/e
    static constexpr double kStillPointsPerSecond = 6;
    static constexpr double kFlightSeconds = 0.3;

    const Camera& camera() const { return camera_; }
    /// The end of a flight; without one the camera itself.
    const Camera& destination() const { return flight_ ? flight_->to : camera_; }
    void set(const Camera& camera);

    /// Rotates as if dragging the molecule's front: 1 degree per point. Sets the speed for inertia.
    void rotate(glm::dvec2 points, double now);
    /// Rotates and zooms about the centre, like a tracked hand.
    void hold(const glm::dquat& orientation, double zoom);
    /// Turns the picture clockwise.
    void roll(double radians);
    void pan(glm::dvec2 points, double radius, const Viewport& viewport);
    /// Zooms about `at` (points), which stays in place.
    void zoom(double factor, glm::dvec2 at, double radius, const Viewport& viewport);

    /// Stops all automatic motion.
    void touch();
    /// Ends a drag: a rotation continues with inertia.
    void release(double now);
    /// Flies to the whole molecule, centred; keeps its orientation.
    void fit(double now);
    /// Flies back to the initial view.
    void reset(double now);
    void fly(const Camera& to, double now, double seconds = kFlightSeconds);
    void setAutoRotation(bool on) { autoRotation_ = on; }
    bool autoRotation() const { return autoRotation_; }
    /// Rocks about the window's vertical axis, to the right first.
    void setRocking(bool on);
    bool rocking() const { return rocking_; }
    void setProjection(Projection projection) { camera_.projection = projection; }

    /// Advances the camera to a time. @returns whether it moved
    bool advance(double now);
    /// Whether it moves without user input.
    bool moving() const { return autoRotation_ || rocking_ || flight_ || gliding_; }

private:
    struct Flight {
        Camera from, to;
        double start, seconds;
    };
    void turn(glm::dvec2 points);

    Camera camera_;
    bool autoRotation_ = false, gliding_ = false, rocking_ = false;
    double swing_ = 0;  // rocking: time within the cycle
    std::optional<Flight> flight_;
    glm::dvec2 velocity_{};  // points per second
    double lastDrag_ = 0;
    std::optional<double> lastAdvance_;
};

}  // namespace nacre::app
