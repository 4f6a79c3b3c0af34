#pragma once
// The camera of a movie at a time: rotating, rocking, or on a smooth path through key views. Pure arithmetic.

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "app/picture/map_options.h"
#include "engine/scene/view/camera.h"

namespace nacre::app {

enum class Easing {
    linear,  ///< constant speed
    smooth,  ///< starts and ends at rest
    stops,   ///< rests at every key view
};

/// Maps 0..1 to 0..1, ascending, with fixed ends.
double eased(Easing easing, double time);

/// "x", "y", "z" or "X,Y,Z"; normalised. @throws std::invalid_argument
glm::dvec3 parseAxis(std::string_view text);

/// A view rotated about an axis through the molecule's centre, in the picture's axes, right-handed. About a coordinate
/// axis exactly rotationMatrix(), so that the picture equals that of `--rotate`.
View turned(View view, const glm::dvec3& axis, double degrees);

/// A map's contour from one level to another of the same unit.
struct LevelSweep {
    MapLevel from, to;
    MapLevel at(double share) const { return {from.unit, from.value + (to.value - from.value) * share}; }
};

/// How a movie shows several models.
enum class MovieModels {
    one,
    sequence,  ///< each after the other, or the frames of a trajectory
    morph      ///< interpolates from each to the next
};

/// How the camera and models move, with duration and frame rate.
struct CameraMotion {
    MovieModels models = MovieModels::one;
    bool loop = false;                ///< the last view, or model of a morph, returns to the first
    std::optional<glm::dvec3> spin;   ///< axis of a turn
    std::optional<double> turns;      ///< of spin; empty: one
    std::optional<double> rock;       ///< degrees to either side
    std::optional<glm::dvec3> axis;   ///< of rock; empty: y
    std::optional<LevelSweep> sweep;  ///< of the first map
    std::optional<Easing> easing;
    std::optional<double> seconds;  ///< empty: movieSeconds()
    double framesPerSecond = 30;
};

/// Sets "spin", "turns", "rock", "axis", "map-sweep", "easing", "seconds" or "fps".
/// @returns whether the key is one of them @throws std::invalid_argument, in words that continue "--key: "
bool setMotion(std::string_view key, std::string_view text, CameraMotion& motion);
/// @throws UsageError for conflicting options
void checkCameraMotion(const CameraMotion& motion);
/// Duration of a morph, a rotation or rocking; else for this many models. @param trajectory  one movie frame per model
double movieSeconds(const CameraMotion& motion, std::uint64_t models, bool trajectory);
/// Position of each frame of a morph between models: 0 is the first, 1 the second.
std::vector<double> morphPlaces(const CameraMotion& motion, std::uint64_t frames, std::uint64_t models);
/// The level of the first map at a time, 0..1; if the camera returns, the level does as well.
MapLevel levelAt(const CameraMotion& motion, double time);
/// A view at a time, 0..1; constant if the camera does not move.
View viewAt(const CameraMotion& motion, const View& view, double time);

/// A view in the file's frame, independent of a molecule's centre.
struct Lens {
    Projection projection = Projection::orthographic;
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 focus{};   ///< point at the picture's centre, in the plane of the original centre, Å
    double scale = 1;     ///< pixels per Å there
    double distance = 0;  ///< perspective: distance of the eye, Å
};

/// @param center  of the view's molecule
Lens makeLens(const View& view, const glm::dvec3& center);
/// @param like    a view of the target molecule, for size and radius @param center  of that molecule
View viewThrough(const Lens& lens, View like, const glm::dvec3& center);

/// A path through lenses: rotation by spherical quadrangles (squad), everything else by cubic Hermite curves without
/// overshoot. It passes through the lenses at integers.
class CameraPath {
public:
    /// @param lenses  at least one, all of one projection @param closed  whether the last leads back to the first
    CameraPath(std::vector<Lens> lenses, bool closed);

    /// Number of segments between lenses.
    std::size_t stretches() const { return closed_ ? lenses_.size() : lenses_.size() - 1; }
    /// @param place  0..stretches()
    Lens at(double place) const;

private:
    const Lens& lens(std::size_t i) const { return lenses_[i % lenses_.size()]; }

    std::vector<Lens> lenses_;
    std::vector<glm::dquat> in_, out_;  ///< control points of the segments before and after a lens
    bool closed_;
};

}  // namespace nacre::app
