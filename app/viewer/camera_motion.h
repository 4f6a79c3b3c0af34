#pragma once
// The camera in the user's hand: a trackball, with inertia, turning by itself, and short flights to another view.

#include <glm/vec2.hpp>
#include <optional>

#include "engine/scene/camera.h"

namespace nacre::app {

/// The window in points.
struct Viewport {
    double width = 1, height = 1;
};

class CameraMotion {
public:
    static constexpr double kDegreesPerPoint = 1.0;
    static constexpr double kAutoDegreesPerSecond = 30.0;
    static constexpr double kRockDegrees = 20, kRockSeconds = 4;  ///< to either side; there and back
    static constexpr double kInertiaSeconds = 0.325;              ///< in which a let-go rotation slows down to 1/e
    static constexpr double kStillPointsPerSecond = 6;
    static constexpr double kFlightSeconds = 0.3;

    const Camera& camera() const { return camera_; }
    /// Where a flight ends; the camera itself where there is none.
    const Camera& destination() const { return flight_ ? flight_->to : camera_; }
    void set(const Camera& camera);

    /// Drags the front of the molecule: 1 degree a point. Sets what inertia goes on with.
    void rotate(glm::dvec2 points, double now);
    /// Turns the picture clockwise.
    void roll(double radians);
    void pan(glm::dvec2 points, double radius, const Viewport& viewport);
    /// Zooms so that what stands at `at` (points) stays there.
    void zoom(double factor, glm::dvec2 at, double radius, const Viewport& viewport);

    /// Whatever moves by itself stops.
    void touch();
    /// The hand lets go: a rotation that was under way goes on for a while.
    void release(double now);
    /// Flies to the whole molecule in the middle; keeps its orientation.
    void fit(double now);
    /// Flies to where everything began.
    void reset(double now);
    void fly(const Camera& to, double now, double seconds = kFlightSeconds);
    void setAutoRotation(bool on) { autoRotation_ = on; }
    bool autoRotation() const { return autoRotation_; }
    /// Swings about the upright of the window, to the right first.
    void setRocking(bool on);
    bool rocking() const { return rocking_; }
    void setProjection(Projection projection) { camera_.projection = projection; }

    /// Brings the camera to a time. @returns whether it moved
    bool advance(double now);
    /// Whether it moves by itself.
    bool moving() const { return autoRotation_ || rocking_ || flight_ || gliding_; }

private:
    struct Flight {
        Camera from, to;
        double start, seconds;
    };
    void turn(glm::dvec2 points);

    Camera camera_;
    bool autoRotation_ = false, gliding_ = false, rocking_ = false;
    double swing_ = 0;  // of rocking: seconds into it
    std::optional<Flight> flight_;
    glm::dvec2 velocity_{};  // points a second
    double lastDrag_ = 0;
    std::optional<double> lastAdvance_;
};

}  // namespace nacre::app
