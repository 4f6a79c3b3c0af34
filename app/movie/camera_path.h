#pragma once
// Where the camera stands at a time of a movie: turning, swinging, or on a smooth path through key views. Pure
// arithmetic on views.

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/scene/camera.h"

namespace nacre::app {

enum class Easing {
    linear,  ///< the same pace throughout
    smooth,  ///< starts and ends at rest
    stops,   ///< comes to rest at every key view
};

/// 0..1 to 0..1, ascending, the ends as they are.
double eased(Easing easing, double time);

/// "x", "y", "z" or "X,Y,Z"; of length 1. @throws std::invalid_argument
glm::dvec3 parseAxis(std::string_view text);

/// A view turned about an axis through the molecule's centre, in the axes of the picture, right-handed. About one of
/// these axes the numbers are those of rotationMatrix(), so that the picture is that of `--rotate`.
View turned(View view, const glm::dvec3& axis, double degrees);

/// How a camera moves by itself, how long and how fast.
struct CameraMotion {
    std::optional<glm::dvec3> spin;  ///< axis of a turn
    std::optional<double> turns;     ///< of spin; empty: one
    std::optional<double> rock;      ///< degrees to either side
    std::optional<glm::dvec3> axis;  ///< of rock; empty: y
    std::optional<Easing> easing;
    std::optional<double> seconds;  ///< empty: secondsOf()
    double framesPerSecond = 30;
};

/// Takes the value of "spin", "turns", "rock", "axis", "easing", "seconds" or "fps".
/// @returns whether it is one of them @throws std::invalid_argument, in words that continue "--key: "
bool setMotion(std::string_view key, std::string_view text, CameraMotion& motion);
/// @throws UsageError for what does not go together
void checkCameraMotion(const CameraMotion& motion);
/// What a turn or a swing takes; else what so many models take. @param trajectory  a frame of the movie for each
double secondsOf(const CameraMotion& motion, std::uint64_t models, bool trajectory);
/// A view at a time, 0..1; the same where no camera moves.
View viewAt(const CameraMotion& motion, const View& view, double time);

/// A view in the file's frame, whatever molecule it was made for.
struct Lens {
    Projection projection = Projection::orthographic;
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 focus{};   ///< what the middle of the picture shows, in the plane of the centre it was made for, Å
    double scale = 1;     ///< pixels per Å there
    double distance = 0;  ///< perspective: from the eye to there, Å
};

/// @param center  of the molecule that the view is of
Lens lensOf(const View& view, const glm::dvec3& center);
/// @param like    a view of the molecule to be seen, for its size and radius
/// @param center  of that molecule
View viewThrough(const Lens& lens, View like, const glm::dvec3& center);

/// A path through lenses: rotation by spherical quadrangles (squad), everything else by cubic Hermite curves that never
/// overshoot. It passes through each at a whole number.
class CameraPath {
public:
    /// @param lenses  at least one, of one projection
    /// @param closed  whether the last is followed by the first
    CameraPath(std::vector<Lens> lenses, bool closed);

    /// How many stretches there are from lens to lens.
    std::size_t stretches() const { return closed_ ? lenses_.size() : lenses_.size() - 1; }
    /// @param place  0..stretches()
    Lens at(double place) const;

private:
    const Lens& lens(std::size_t i) const { return lenses_[i % lenses_.size()]; }

    std::vector<Lens> lenses_;
    std::vector<glm::dquat> in_, out_;  ///< control points of the stretch that ends at a lens, and of the one after it
    bool closed_;
};

}  // namespace nacre::app
