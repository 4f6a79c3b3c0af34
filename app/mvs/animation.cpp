#include "app/mvs/animation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <map>
#include <numbers>
#include <span>
#include <stdexcept>

#include "app/mvs/primitive_values.h"
#include "app/mvs/value_palette.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

constexpr double kLongestAnimation = 3'600'000;  // ms
constexpr double kRounding = 1e-6;

[[noreturn]] void refuseMotion(const std::string& why) { throw std::invalid_argument(why); }

double bounceOut(double t) {
    struct Jump {
        double from, middle, height;
    };
    for (const Jump& jump : {Jump{2.5, 2.625, 0.984375}, Jump{2, 2.25, 0.9375}, Jump{1, 1.5, 0.75}})
        if (t * 2.75 >= jump.from) return 7.5625 * std::pow(t - jump.middle / 2.75, 2) + jump.height;
    return 7.5625 * t * t;
}

double easeIn(std::string_view curve, double t) {
    if (curve == "quad") return t * t;
    if (curve == "cubic") return t * t * t;
    if (curve == "sin") return 1 - std::cos(t * std::numbers::pi / 2);
    if (curve == "circle") return 1 - std::sqrt(std::max(1 - t * t, 0.0));
    if (curve == "exp") return std::exp2(10 * t - 10);
    return 1 - bounceOut(1 - t);
}

double readTime(const Node& node, const char* name, double otherwise) {
    const Json* value = node.param(name);
    return value && value->is_number() ? std::clamp(value->get<double>(), 0.0, kLongestAnimation) : otherwise;
}
double readStart(const Node& node) { return readTime(node, "start_ms", 0); }
double readDuration(const Node& node) { return readTime(node, "duration_ms", 0); }

void findRefs(Node& node, std::map<std::string, Node*>& nodes) {
    if (!node.ref.empty()) nodes.emplace(node.ref, &node);
    for (Node& child : node.children) findRefs(child, nodes);
}

std::vector<Json> readPath(const Node& node) {
    const Json* property = node.param("property");
    if (!property) refuseMotion("it names no property");
    std::vector<Json> path;
    if (property->is_array())
        for (const Json& step : *property) path.push_back(step);
    else
        path.push_back(*property);
    for (const Json& step : path)
        if (!step.is_string() && !step.is_number_unsigned())
            refuseMotion("its property is no name and no list of names");
    if (path.empty() || path.front() == "custom" || !path.front().is_string())
        refuseMotion("its property is no parameter of a node");
    return path;
}

/// The value at a path; null: there is none.
Json* valueAt(Json& params, std::span<const Json> path) {
    Json* at = &params;
    for (const Json& step : path) {
        if (step.is_string() && at->is_object() && at->contains(step.get<std::string>()))
            at = &(*at)[step.get<std::string>()];
        else if (step.is_number_unsigned() && at->is_array() && step.get<std::size_t>() < at->size())
            at = &(*at)[step.get<std::size_t>()];
        else
            return nullptr;
    }
    return at;
}

void assign(Json& params, std::span<const Json> path, Json value) {
    Json* parent = valueAt(params, path.first(path.size() - 1));
    if (Json* known = parent ? valueAt(*parent, path.last(1)) : nullptr)
        *known = std::move(value);
    else if (parent && parent->is_object() && path.back().is_string())
        (*parent)[path.back().get<std::string>()] = std::move(value);
    else
        refuseMotion("the node has no such property");
}

/// The finished fraction of an interpolation. @param prefix  of the parameters' names: "", "rotation_"
double computeProgress(const Node& node, double time, const std::string& prefix = "") {
    const Json* given = node.param((prefix + "frequency").c_str());
    const double frequency = given && given->is_number() ? std::clamp(given->get<double>(), 0.0, 1e6) : 1;
    double share = std::clamp(time, 0.0, 1.0) * (frequency > 0 ? frequency : 1);
    if (share > 1 + kRounding || (share >= 1 && frequency > 1)) {
        if (flag(node, (prefix + "alternate_direction").c_str(), false)) {
            share = std::abs(share - 1) < kRounding ? 1 : std::fmod(share, 2);
            if (share > 1) share = 2 - share;
        } else {
            share = std::fmod(share, 1);
            if (share < kRounding) share = 1;
        }
    }
    const std::string easing = nodeText(node, (prefix + "easing").c_str());
    return easing.empty() ? share : easedByName(easing, share).value_or(share);
}

double boundedNumber(const Json& value) {
    if (!value.is_number() || !(std::abs(value.get<double>()) <= 1e9)) refuseMotion("a value is no number within 1e9");
    return value.get<double>();
}

Json mixedNumber(const Json& from, const Json& to, double share, bool whole) {
    const double a = boundedNumber(from), value = a + (boundedNumber(to) - a) * share;
    return whole ? Json(static_cast<std::int64_t>(std::llround(value))) : Json(value);
}

Json mixedNumbers(const Json& from, const Json& to, double share, bool whole) {
    if (!from.is_array() && !to.is_array()) return mixedNumber(from, to, share, whole);
    const Json& list = from.is_array() ? from : to;
    if (from.is_array() && to.is_array() && from.size() != to.size()) refuseMotion("its lists differ in length");
    Json mixed = Json::array();
    for (std::size_t i = 0; i < list.size(); ++i)
        mixed.push_back(mixedNumber(from.is_array() ? from[i] : from, to.is_array() ? to[i] : to, share, whole));
    return mixed;
}

/// Along a great circle, with linear interpolation of the length.
glm::dvec3 turnedBetween(const glm::dvec3& from, const glm::dvec3& to, double share) {
    const double a = glm::length(from), b = glm::length(to);
    const glm::dvec3 axis = glm::cross(from, to);
    if (!(glm::length(axis) > 1e-9 * a * b)) return from + (to - from) * share;
    const double angle = std::atan2(glm::length(axis), glm::dot(from, to)) * share;
    return glm::angleAxis(angle, glm::normalize(axis)) * from * ((a + (b - a) * share) / a);
}

Json mixedVectors(const Json& from, const Json& to, double share, bool spherical) {
    if (!from.is_array() || !to.is_array() || from.size() % 3 != 0)
        refuseMotion("its start or end is no list of three numbers each");
    Json mixed = mixedNumbers(from, to, share, false);
    for (std::size_t i = 0; spherical && i < mixed.size(); i += 3) {
        glm::dvec3 a, b;
        for (int k = 0; k < 3; ++k) a[k] = boundedNumber(from[i + k]), b[k] = boundedNumber(to[i + k]);
        const glm::dvec3 turned = turnedBetween(a, b, share);
        for (int k = 0; k < 3; ++k) mixed[i + k] = turned[k];
    }
    return mixed;
}

glm::dmat3 readTurn(const Json& value) {
    const std::vector<double> numbers = numbersIn("a rotation", value, 9);
    return glm::make_mat3(numbers.data());
}

/// Between equal rotations, interpolates a full turn about z, as in Mol*.
glm::dmat3 mixedRotation(const glm::dmat3& from, const glm::dmat3& to, double share) {
    const glm::dquat a = glm::normalize(glm::quat_cast(from)), b = glm::normalize(glm::quat_cast(to));
    if (std::abs(glm::dot(a, b)) > 1 - 1e-13)
        return glm::mat3_cast(glm::angleAxis(2 * std::numbers::pi * share, glm::dvec3(0, 0, 1)));
    return glm::mat3_cast(glm::slerp(a, b, share));
}

Json toList(const double* numbers, std::size_t count) { return std::vector<double>(numbers, numbers + count); }

std::uint32_t colorInMotion(const Json& value) {
    const auto color = readColor(&value);
    if (!color) refuseMotion("it names no colour: " + nacre::printable(value.dump(-1, ' ', true), 40));
    return *color;
}

Json mixedColors(const Json& from, const Json& to, double share, const Json* base) {
    if (!from.is_object()) return colorText(mixedColor(colorInMotion(from), colorInMotion(to), share));
    Json mixed = base && base->is_object() ? *base : Json::object();
    mixed.update(from);
    const Json start = mixed;
    for (const auto& [key, color] : start.items()) {
        if (to.is_object() && !to.contains(key)) continue;
        mixed[key] = colorText(mixedColor(colorInMotion(color), colorInMotion(to.is_object() ? to[key] : to), share));
    }
    return mixed;
}

/// The end value of an earlier interpolation, else the node's value.
const Json* findStart(const Node& node, const Node* before, const Json* current) {
    if (const Json* own = node.param("start")) return own;
    if (const Json* last = before ? before->param("end") : nullptr) return last;
    return current;
}

/// A start of a matrix: that of an earlier interpolation, as in Mol*.
const Json* findMatrixStart(const Node& node, const Node* before, const char* name) {
    const Json* own = node.param(name);
    return own || !before ? own : before->param(name);
}

glm::dvec3 vectorOr(const char* name, const Json* value, const glm::dvec3& otherwise) {
    return value ? vectorIn(name, *value) : otherwise;
}

Json transformed(const Node& node, const Node* before, const Json* current, double time) {
    glm::dmat4 matrix(1.0);
    if (current) {
        const std::vector<double> numbers = numbersIn("its matrix", *current, 16);
        matrix = glm::make_mat4(numbers.data());
    }
    const Json *startTurn = findMatrixStart(node, before, "rotation_start"), *endTurn = node.param("rotation_end");
    glm::dmat3 turn = startTurn ? readTurn(*startTurn) : glm::dmat3(matrix);
    if (endTurn && time > 0) turn = mixedRotation(turn, readTurn(*endTurn), computeProgress(node, time, "rotation_"));
    glm::dvec3 shift =
        vectorOr("translation_start", findMatrixStart(node, before, "translation_start"), glm::dvec3(matrix[3]));
    const glm::dvec3 end = vectorOr("translation_end", node.param("translation_end"), shift);
    shift += (end - shift) * (time > 0 ? computeProgress(node, time, "translation_") : 0);
    const glm::dvec3 pivot = vectorOr("pivot", node.param("pivot"), glm::dvec3(0));
    glm::dmat4 result(turn);
    result[3] = glm::dvec4(shift - turn * pivot, 1);  // without the shift back from the pivot, as in Mol*
    return toList(&result[0][0], 16);
}

/// The value of a parameter at a time, 0..1 of the interpolation.
Json interpolated(const Node& node, const Node* before, const Json* current, double time) {
    const std::string kind = nodeText(node, "kind");
    if (kind == "transform_matrix") return transformed(node, before, current, time);
    const Json *from = findStart(node, before, current), *to = node.param("end");
    if (const Json* palette = kind == "color" ? node.param("palette") : nullptr) {
        if (time <= 0) return from ? *from : Json();
        const auto color = paletteColorAt(*palette, computeProgress(node, time));
        return colorText(color.value_or(0xff000000u));
    }
    if (!from) refuseMotion("it has no start");
    if (!to) return *from;
    const double share = time <= 0 ? 0 : computeProgress(node, time);
    if (kind == "scalar") return mixedNumbers(*from, *to, share, flag(node, "discrete", false));
    if (kind == "vec3") return mixedVectors(*from, *to, share, flag(node, "spherical", false));
    if (kind == "color") return mixedColors(*from, *to, share, current);
    const glm::dmat3 turn = time <= 0 ? readTurn(*from) : mixedRotation(readTurn(*from), readTurn(*to), share);
    return toList(&turn[0][0], 9);
}

/// Interpolations of one property, in the order of their times.
struct Track {
    std::vector<const Node*> parts;

    void add(const Node& node) {
        const auto later = [](const Node* a, const Node* b) {
            return std::pair(readStart(*a), readDuration(*a)) < std::pair(readStart(*b), readDuration(*b));
        };
        parts.insert(std::upper_bound(parts.begin(), parts.end(), &node, later), &node);
    }
    /// Index of the last interpolation that has begun, or the first.
    std::size_t at(double ms) const {
        std::size_t place = parts.size() - 1;
        while (place > 0 && ms < readStart(*parts[place])) --place;
        return place;
    }
};

/// The time whose values are shown at a time: that of the next frame, as in Mol*, if the animation has slow frames.
double timeOfFrame(const Node& animation, double ms) {
    const double frame = readTime(animation, "frame_time_ms", 0);
    return frame <= 0 ? ms : ms <= frame ? 0 : std::ceil(ms / frame - kRounding) * frame;
}

bool isHeld(const Node& target, const Snapshot& snapshot) {
    const bool camera = target.kind == "camera" || target.kind == "focus";
    return (camera && !animationFlag(snapshot, "include_camera")) ||
           (target.kind == "canvas" && !animationFlag(snapshot, "include_canvas"));
}

}  // namespace

std::optional<double> easedByName(std::string_view easing, double time) {
    const double t = std::clamp(time, 0.0, 1.0);
    if (easing == "linear") return t;
    for (const std::string_view curve : {"bounce", "circle", "cubic", "exp", "quad", "sin"}) {
        if (!easing.starts_with(curve)) continue;
        const std::string_view way = easing.substr(curve.size());
        if (t == 0 || t == 1)
            return way == "-in" || way == "-out" || way == "-in-out" ? std::optional(t) : std::nullopt;
        if (way == "-in") return easeIn(curve, t);
        if (way == "-out") return 1 - easeIn(curve, 1 - t);
        if (way == "-in-out") return t < 0.5 ? easeIn(curve, 2 * t) / 2 : 1 - easeIn(curve, 2 - 2 * t) / 2;
    }
    return std::nullopt;
}

CameraTransition readTransition(const Node& node) {
    CameraTransition transition{.seconds = readDuration(node) / 1000};
    if (node.param("easing")) transition.easing = nodeText(node, "easing");
    if (node.param("trajectory")) transition.trajectory = nodeText(node, "trajectory");
    return transition;
}

std::optional<CameraTransition> transitionTo(const Snapshot& snapshot) {
    for (const Node& node : snapshot.root.children)
        if (node.kind == "transition") return readTransition(node);
    return std::nullopt;
}

double animationSeconds(const Snapshot& snapshot) {
    const Node& animation = snapshot.animation;
    double longest = 0;
    if (animation.kind != "animation") return 0;
    for (const Node& node : animation.children)
        if (node.kind == "interpolate") longest = std::max(longest, readStart(node) + readDuration(node));
    return longest > 0 ? std::min(std::max(longest, readDuration(animation)), kLongestAnimation) / 1000 : 0;
}

bool animationFlag(const Snapshot& snapshot, const char* name) { return flag(snapshot.animation, name, false); }

Snapshot animatedAt(const Snapshot& snapshot, double seconds, SceneWarnings& warnings) {
    Snapshot moved = snapshot;
    std::map<std::string, Node*> nodes;
    findRefs(moved.root, nodes);
    tellUnused(snapshot.animation, *nodeRow("animation"), warnings);
    std::map<std::string, Track> tracks;
    for (const Node& node : snapshot.animation.children) {
        tellUnknown(node, snapshot.animation, warnings);
        if (node.kind != "interpolate") continue;
        const std::string kind = nodeText(node, "kind");
        const NodeRow* row = nodeRow("interpolate:" + kind);
        if (!row)
            warnings.add(node, "there is no interpolation '" + nacre::printable(kind, 40) + "': it is left out");
        else
            tellUnused(node, *row, warnings);
        const Json* property = node.param("property");
        if (row) tracks[nodeText(node, "target_ref") + '\0' + (property ? property->dump() : "")].add(node);
    }
    const double ms = timeOfFrame(snapshot.animation, seconds * 1000);
    for (const auto& [name, track] : tracks) {
        const std::size_t place = track.at(ms);
        const Node& node = *track.parts[place];
        const std::string ref = nodeText(node, "target_ref");
        const auto target = nodes.find(ref);
        try {
            if (target == nodes.end()) refuseMotion("there is no node '" + nacre::printable(ref, 40) + "'");
            if (isHeld(*target->second, snapshot)) continue;
            const std::vector<Json> path = readPath(node);
            const Json* current = valueAt(target->second->params, path);
            const double duration = readDuration(node), since = ms - readStart(node);
            const double time = duration > 0 ? since / duration : since < 0 ? 0 : 1;
            assign(target->second->params, path,
                   interpolated(node, place > 0 ? track.parts[place - 1] : nullptr, current, time));
        } catch (const std::invalid_argument& why) {
            warnings.add(node, why.what() + std::string(": it is left out"));
        }
    }
    return moved;
}

}  // namespace nacre::app::mvs
