#include "app/movie/camera_path.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>
#include <string>

#include "app/movie/movie_file.h"
#include "app/picture/option_values.h"
#include "app/picture/usage_error.h"

namespace nacre::app {
namespace {

double rest(double t) { return t * t * (3 - 2 * t); }

/// A unit quaternion's rotation as axis times half its angle, and back.
glm::dvec3 logarithm(const glm::dquat& q) {
    const glm::dvec3 v(q.x, q.y, q.z);
    const double sine = glm::length(v);
    return sine < 1e-12 ? v : v * (std::atan2(sine, q.w) / sine);
}
glm::dquat exponential(const glm::dvec3& v) {
    const double half = glm::length(v);
    const double share = half < 1e-12 ? 1 : std::sin(half) / half;
    return {std::cos(half), v.x * share, v.y * share, v.z * share};
}

/// Spherical interpolation in the direction given by the signs, even if it is the longer one.
glm::dquat between(const glm::dquat& a, const glm::dquat& b, double t) {
    const glm::dvec3 way = logarithm(glm::conjugate(a) * b);
    return glm::normalize(a * exponential(way * t));
}

/// Slope at a point between its two neighbours: zero at an extremum, so that the curve does not overshoot (after
/// Fritsch and Carlson 1980, with the harmonic mean).
double slope(double before, double after) { return before * after <= 0 ? 0 : 2 * before * after / (before + after); }

/// The cubic from b to c at t, with neighbours a and d.
double curve(double a, double b, double c, double d, bool first, bool last, double t) {
    const double way = c - b;
    const double leave = first ? way : slope(b - a, way), arrive = last ? way : slope(way, d - c);
    const double t2 = t * t, t3 = t2 * t;
    return b + (t3 - 2 * t2 + t) * leave + (3 * t2 - 2 * t3) * way + (t3 - t2) * arrive;
}

/// "FROM,TO": two levels of the same unit.
LevelSweep parseSweep(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) throw std::invalid_argument("expected two levels, 1sigma,3sigma");
    const LevelSweep sweep{parseMapLevel(text.substr(0, comma)), parseMapLevel(text.substr(comma + 1))};
    if (sweep.from.unit != sweep.to.unit || sweep.from.unit == MapLevel::Unit::automatic)
        throw std::invalid_argument("expected two levels of the same unit, 1sigma,3sigma or 0.01,0.05");
    return sweep;
}

}  // namespace

double eased(Easing easing, double time) {
    const double t = std::clamp(time, 0.0, 1.0);
    return easing == Easing::smooth ? rest(t) : t;
}

glm::dvec3 parseAxis(std::string_view text) {
    if (text == "x") return {1, 0, 0};
    if (text == "y") return {0, 1, 0};
    if (text == "z") return {0, 0, 1};
    glm::dvec3 axis(0);
    try {
        axis = parseRotation(text);
    } catch (const std::invalid_argument&) {
        throw std::invalid_argument("expected x, y, z or a vector X,Y,Z, not '" + std::string(text) + "'");
    }
    const double length = glm::length(axis);
    if (!(length > 1e-9 && length < 1e9)) throw std::invalid_argument("the axis has no direction");
    return axis / length;
}

MapLevel levelAt(const CameraMotion& motion, double time) {
    const bool back = motion.spin || motion.rock;
    const double share = back ? 1 - std::abs(2 * time - 1) : time;
    return motion.sweep->at(eased(motion.easing.value_or(Easing::linear), share));
}

bool setMotion(std::string_view key, std::string_view text, CameraMotion& motion) {
    constexpr Easing kEasings[] = {Easing::linear, Easing::smooth, Easing::stops};
    const auto moves = [](double value, const char* what) {
        if (value == 0) throw std::invalid_argument(std::string("0 ") + what + " show no motion");
        return value;
    };
    if (key == "spin")
        motion.spin = parseAxis(text);
    else if (key == "turns")
        motion.turns = moves(parseNumber(text, -100, 100), "turns");
    else if (key == "rock")
        motion.rock = moves(parseNumber(text, 0, 180), "degrees");
    else if (key == "axis")
        motion.axis = parseAxis(text);
    else if (key == "map-sweep")
        motion.sweep = parseSweep(text);
    else if (key == "easing")
        motion.easing = kEasings[parseChoice(text, {"linear", "smooth", "stops"})];
    else if (key == "seconds")
        motion.seconds = parseNumber(text, 0.001, 86400);
    else if (key == "fps")
        motion.framesPerSecond = parseNumber(text, kSlowestMovie, kFastestMovie);
    else
        return false;
    return true;
}

void checkCameraMotion(const CameraMotion& motion) {
    if (motion.spin && motion.rock) throw UsageError("--spin and --rock exclude each other");
    if (motion.turns && !motion.spin) throw UsageError("--turns is for --spin");
    if (motion.axis && !motion.rock) throw UsageError("--axis is for --rock (--spin names its own)");
}

double movieSeconds(const CameraMotion& motion, std::uint64_t models, bool trajectory) {
    constexpr double kSpinSeconds = 6, kRockSeconds = 4, kModelSeconds = 0.1, kSweepSeconds = 4, kStepSeconds = 2;
    if (motion.seconds) return *motion.seconds;
    if (motion.models == MovieModels::morph)
        return kStepSeconds * static_cast<double>(motion.loop ? models : models - 1);
    if (motion.rock) return kRockSeconds;
    if (motion.spin) return kSpinSeconds;
    if (motion.sweep) return kSweepSeconds;
    return static_cast<double>(models) * (trajectory ? 1 / motion.framesPerSecond : kModelSeconds);
}

std::vector<double> morphPlaces(const CameraMotion& motion, std::uint64_t frames, std::uint64_t models) {
    const Easing easing = motion.easing.value_or(Easing::smooth);
    const auto last = static_cast<double>(motion.loop ? models : models - 1);
    const auto steps = static_cast<double>(motion.loop ? frames : std::max<std::uint64_t>(frames - 1, 1));
    std::vector<double> places;
    for (std::uint64_t frame = 0; frame < frames; ++frame) {
        const double time = static_cast<double>(frame) / steps, key = std::floor(time * last);
        places.push_back(easing == Easing::stops ? key + eased(Easing::smooth, time * last - key)
                                                 : last * eased(easing, time));
    }
    return places;
}

View viewAt(const CameraMotion& motion, const View& view, double time) {
    const double t = eased(motion.easing.value_or(Easing::linear), time);
    if (motion.spin) return turned(view, *motion.spin, 360 * motion.turns.value_or(1) * t);
    if (motion.rock)
        return turned(view, motion.axis.value_or(glm::dvec3(0, 1, 0)),
                      *motion.rock * std::sin(2 * std::numbers::pi * t));
    return view;
}

View turned(View view, const glm::dvec3& axis, double degrees) {
    const bool along = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)}) == 1.0;
    const glm::dmat3 turn =
        along ? rotationMatrix(axis * degrees) : glm::mat3_cast(glm::angleAxis(degrees * std::numbers::pi / 180, axis));
    if (std::remainder(degrees, 360.0) != 0) view.rotation = turn * view.rotation;
    return view;
}

Lens makeLens(const View& view, const glm::dvec3& center) {
    Lens lens;
    lens.projection = view.projection;
    lens.rotation = glm::normalize(glm::quat_cast(view.rotation));
    lens.focus = center - glm::transpose(view.rotation) * glm::dvec3(view.pan, 0);
    lens.scale = view.pixelsPerAngstrom;
    lens.distance = view.eyeDistance;
    return lens;
}

View viewThrough(const Lens& lens, View like, const glm::dvec3& center) {
    like.projection = lens.projection;
    like.rotation = glm::mat3_cast(lens.rotation);
    const glm::dvec3 focus = like.rotation * (lens.focus - center);
    like.pan = -glm::dvec2(focus);
    like.pixelsPerAngstrom = lens.scale;
    like.eyeDistance = 0;
    if (lens.projection == Projection::perspective) {
        // The eye stays; the scale now refers to the plane of another centre.
        like.eyeDistance = std::max(lens.distance + focus.z, like.radius * 1.02);
        like.pixelsPerAngstrom = lens.scale * lens.distance / like.eyeDistance;
    }
    return like;
}

CameraPath::CameraPath(std::vector<Lens> lenses, bool closed)
    : lenses_(std::move(lenses)), closed_(closed && lenses_.size() > 1) {
    const std::size_t count = lenses_.size();
    for (std::size_t i = 1; i < count; ++i)  // takes the shorter way each time
        if (glm::dot(lenses_[i - 1].rotation, lenses_[i].rotation) < 0) lenses_[i].rotation = -lenses_[i].rotation;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dquat q = lenses_[i].rotation;
        const auto way = [&](std::size_t to) {
            glm::dquat other = lenses_[to].rotation;
            if (glm::dot(q, other) < 0) other = -other;
            return logarithm(glm::conjugate(q) * other);
        };
        const bool first = !closed_ && i == 0, last = !closed_ && i + 1 == count;
        const glm::dvec3 before = first ? glm::dvec3(0) : way((i + count - 1) % count);
        const glm::dvec3 after = last ? glm::dvec3(0) : way((i + 1) % count);
        // The motion stops where it turns back or rests.
        glm::dvec3 pace = glm::dot(after, -before) <= 0 ? glm::dvec3(0) : (after - before) / 2.0;
        if (first) pace = after;
        if (last) pace = -before;
        out_.push_back(q * exponential((pace - after) / 2.0));
        in_.push_back(q * exponential((-pace - before) / 2.0));
    }
}

Lens CameraPath::at(double place) const {
    const std::size_t count = lenses_.size();
    if (stretches() == 0) return lenses_.front();
    const auto i = std::min(static_cast<std::size_t>(std::max(place, 0.0)), stretches() - 1);
    const double t = std::clamp(place - static_cast<double>(i), 0.0, 1.0);
    const Lens &b = lens(i), &c = lens(i + 1);
    const bool first = !closed_ && i == 0, last = !closed_ && i + 2 == count;
    const Lens &a = first ? b : lens(i + count - 1), &d = last ? c : lens(i + 2);
    const auto along = [&](auto&& value) { return curve(value(a), value(b), value(c), value(d), first, last, t); };

    Lens result = b;
    const auto facing = [](const glm::dquat& to, const glm::dquat& q) { return glm::dot(to, q) < 0 ? -q : q; };
    const glm::dquat end = facing(b.rotation, c.rotation);
    const glm::dquat leave = facing(b.rotation, out_[i]), arrive = facing(end, in_[(i + 1) % count]);
    result.rotation = between(between(b.rotation, end, t), between(leave, arrive, t), 2 * t * (1 - t));
    for (int k = 0; k < 3; ++k) result.focus[k] = along([k](const Lens& lens) { return lens.focus[k]; });
    result.scale = std::exp(along([](const Lens& lens) { return std::log(lens.scale); }));
    result.distance = along([](const Lens& lens) { return lens.distance; });
    return result;
}

}  // namespace nacre::app
