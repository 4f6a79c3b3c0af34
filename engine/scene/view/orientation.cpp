#include "engine/scene/view/orientation.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "engine/molecule/displacement.h"
#include "engine/scene/view/bounds.h"

namespace nacre {
namespace {

using Balls = std::vector<glm::dvec4>;

glm::dvec3 computeMean(const Balls& balls) {
    glm::dvec3 sum(0);
    for (const glm::dvec4& ball : balls) sum += glm::dvec3(ball);
    return sum / static_cast<double>(balls.size());
}

PrincipalAxes findAxes(const Balls& balls, const glm::dvec3& mean) {
    glm::dmat3 covariance(0.0);
    for (const glm::dvec4& ball : balls) {
        const glm::dvec3 p = glm::dvec3(ball) - mean;
        covariance += glm::outerProduct(p, p);
    }
    return principalAxes(covariance / static_cast<double>(balls.size()));
}

/// The axis, with the sign of the side on which the points reach farther.
glm::dvec3 directed(const glm::dvec3& axis, const Balls& balls, const glm::dvec3& mean) {
    constexpr double kSkewed = 1e-3;
    double squares = 0, cubes = 0;
    for (const glm::dvec4& ball : balls) {
        const double at = glm::dot(glm::dvec3(ball) - mean, axis);
        squares += at * at;
        cubes += at * at * at;
    }
    const double count = static_cast<double>(balls.size());
    const double skewness = squares > 0 ? cubes / count / std::pow(squares / count, 1.5) : 0;
    if (std::abs(skewness) > kSkewed) return skewness > 0 ? axis : -axis;
    int largest = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(axis[i]) > std::abs(axis[largest]) + 1e-6) largest = i;
    return axis[largest] < 0 ? -axis : axis;
}

/// The component of the file's axis `wanted`, or else another one, perpendicular to a unit vector.
glm::dvec3 acrossFrom(const glm::dvec3& unit, int wanted) {
    for (const int i : {wanted, (wanted + 2) % 3, (wanted + 1) % 3}) {
        glm::dvec3 file(0);
        file[i] = 1;
        const glm::dvec3 across = file - unit * unit[i];
        if (glm::length(across) > 0.5) return glm::normalize(across);
    }
    return {1, 0, 0};  // impossible: at most one of three axes is near the vector
}

/// Directions spread evenly over the sphere, by falling z: spherical Fibonacci, as in the occlusion bake.
std::vector<glm::dvec3> directionsAround(std::size_t count) {
    std::vector<glm::dvec3> ways;
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
        const double turn = 2 * std::numbers::pi * static_cast<double>(i) / std::numbers::phi;
        const double r = std::sqrt(1 - z * z);
        ways.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
    }
    return ways;
}

/// For each direction, the fraction of targets that are visible along it from outside the molecule.
std::vector<double> openShares(const Balls& targets, const Balls& others, const std::vector<glm::dvec3>& ways) {
    const auto count = static_cast<double>(ways.size());
    std::vector<double> open(ways.size());
    std::vector<bool> blocked;
    for (const glm::dvec4& target : targets) {
        blocked.assign(ways.size(), false);
        for (const glm::dvec4& ball : others) {
            const glm::dvec3 to = glm::dvec3(ball) - glm::dvec3(target);
            const double distance = glm::length(to);
            if (distance < 1e-3 || ball.w == 0) continue;
            // A touching atom still leaves the directions beside it open.
            const double angle = std::asin(std::min(ball.w / distance, 1.0));
            const double z = std::clamp(to.z / distance, -1.0, 1.0), polar = std::acos(z);
            const double top = std::cos(std::max(polar - angle, 0.0));
            const double bottom = std::cos(std::min(polar + angle, std::numbers::pi));
            const auto place = [&](double height) { return std::clamp((1 - height) * count / 2, 0.0, count); };
            const auto end = static_cast<std::size_t>(std::ceil(place(bottom)));
            for (auto i = static_cast<std::size_t>(place(top)); i < std::min(end, ways.size()); ++i)
                if (glm::dot(ways[i], to) > distance * std::cos(angle)) blocked[i] = true;
        }
        for (std::size_t i = 0; i < ways.size(); ++i)
            open[i] += blocked[i] ? 0 : 1.0 / static_cast<double>(targets.size());
    }
    return open;
}

Balls without(const Balls& all, Balls some) {
    const auto before = [](const glm::dvec4& a, const glm::dvec4& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::sort(some.begin(), some.end(), before);
    Balls rest;
    for (const glm::dvec4& ball : all)
        if (!std::binary_search(some.begin(), some.end(), ball, before)) rest.push_back(ball);
    return rest;
}

/// A sample of the balls, spread evenly through the list.
Balls takeSample(const Balls& balls, std::size_t most) {
    Balls some;
    const std::size_t step = (balls.size() + most - 1) / most;
    for (std::size_t i = 0; i < balls.size(); i += step) some.push_back(balls[i]);
    return some;
}

constexpr std::size_t kEveryCopy = std::numeric_limits<std::size_t>::max();

/// Calls add(primitive, transform) for everything drawn. @param most  copies of each primitive
template <typename Add>
void forEachCopy(const Copies& copies, const std::vector<PrimitiveRun>& runs, std::size_t count, std::size_t most,
                 Add&& add) {
    if (copies.transforms.empty())
        for (std::size_t i = 0; i < count; ++i) add(i, glm::dmat4x3(1.0));
    for (const PrimitiveRun& run : runs)
        for (const std::uint32_t copy :
             std::span(copies.lists[run.list]).first(std::min(most, copies.lists[run.list].size())))
            for (std::size_t i = run.first; i < std::size_t{run.first} + run.count; ++i)
                add(i, copies.transforms[copy]);
}

/// Calls add(vertex, step, transform) for the vertices of triangles; for shared ones once or more.
template <typename Add>
void forEachVertex(const Representation& scene, std::size_t mostCopies, Add&& add) {
    const auto addTriangle = [&](std::size_t i, const glm::dmat4x3& place) {
        const Triangle& triangle = scene.triangles[i];
        // Neighbours in a strip share two vertices.
        const auto before = [&](std::uint32_t vertex) {
            if (i == 0) return false;
            const Triangle& last = scene.triangles[i - 1];
            return last.a == vertex || last.b == vertex || last.c == vertex;
        };
        for (const std::uint32_t vertex : {triangle.a, triangle.b, triangle.c})
            if (!before(vertex)) add(scene.meshVertices[vertex], triangle.step(), place);
    };
    forEachCopy(scene.copies, scene.copies.triangles, scene.triangles.size(), mostCopies, addTriangle);
}

/// Ends of lines, with the number of their atom (0: none). In an assembly, lines are stored in place.
template <typename Visit>
void eachLineEnd(const Representation& scene, const Visit& visit) {
    for (std::size_t i = 0; i < scene.wires.size(); ++i) {
        visit(glm::dvec4(scene.wires[i].a, 0.0), scene.wireLooks[i].atomA);
        visit(glm::dvec4(scene.wires[i].b, 0.0), scene.wireLooks[i].atomB);
    }
}

template <typename Visit>
void eachDrawnBall(const Representation& scene, const Visit& visit) {
    const auto ofSphere = [&](std::size_t i, const glm::dmat4x3& place) {
        const Sphere& s = scene.spheres[i];
        visit(glm::dvec4(place * glm::dvec4(s.center, 1.0), s.radius));
    };
    const auto ofVertex = [&](const MeshVertex& vertex, float step, const glm::dmat4x3& place) {
        visit(glm::dvec4(place * glm::dvec4(decodePosition(vertex, step), 1.0), 0.0));
    };
    forEachCopy(scene.copies, scene.copies.spheres, scene.spheres.size(), kEveryCopy, ofSphere);
    forEachVertex(scene, kEveryCopy, ofVertex);
    eachLineEnd(scene, [&](const glm::dvec4& end, std::uint32_t) { visit(end); });
}

/// As above for maps and primitives in addition to a molecule; they may contain sticks.
template <typename Visit>
void eachBallBeside(const Representation& beside, const Visit& visit) {
    eachDrawnBall(beside, visit);
    for (const Cylinder& stick : beside.cylinders) {
        visit(glm::dvec4(stick.a, stick.radius));
        visit(glm::dvec4(stick.b, stick.radius));
    }
}

/// Number of spheres, triangle vertices and ends of lines in all copies.
double drawnBallCount(const Representation& scene) {
    if (scene.copies.transforms.empty())
        return static_cast<double>(scene.spheres.size() + 2 * scene.wires.size()) +
               3 * static_cast<double>(scene.triangles.size());
    double count = 2 * static_cast<double>(scene.wires.size());
    for (const auto& [runs, each] : {std::pair(&scene.copies.spheres, 1.0), std::pair(&scene.copies.triangles, 3.0)})
        for (const PrimitiveRun& run : *runs)
            count += each * run.count * static_cast<double>(scene.copies.lists[run.list].size());
    return count;
}

}  // namespace

std::vector<glm::dvec4> drawnBalls(const Representation& scene) {
    Balls balls;
    balls.reserve(scene.drawnAtoms);
    eachDrawnBall(scene, [&](const glm::dvec4& ball) { balls.push_back(ball); });
    return balls;
}

std::vector<glm::dvec4> chosenBalls(const Representation& scene, const std::vector<bool>& chosen) {
    Balls balls;
    const auto addSphere = [&](std::size_t i, const glm::dmat4x3& place) {
        const Sphere& s = scene.spheres[i];
        const std::uint32_t number = scene.sphereLooks[i].atom;
        if (number <= chosen.size() && chosen[number - 1])
            balls.emplace_back(place * glm::dvec4(s.center, 1.0), static_cast<double>(s.radius));
    };
    const auto addVertex = [&](const MeshVertex& vertex, float step, const glm::dmat4x3& place) {
        if (chosen[scene.meshLooks[vertex.look].atom - 1])
            balls.emplace_back(place * glm::dvec4(decodePosition(vertex, step), 1.0), 0.0);
    };
    forEachCopy(scene.copies, scene.copies.spheres, scene.spheres.size(), 1, addSphere);
    forEachVertex(scene, 1, addVertex);
    std::vector<bool> known(scene.copies.transforms.empty() ? 0 : chosen.size());
    eachLineEnd(scene, [&](const glm::dvec4& end, std::uint32_t number) {
        if (number == 0 || number > chosen.size() || !chosen[number - 1]) return;
        if (!known.empty() && known[number - 1]) return;  // a further copy
        if (!known.empty()) known[number - 1] = true;
        balls.push_back(end);
    });
    return balls;
}

glm::dquat principalOrientation(const std::vector<glm::dvec4>& balls, bool wide) {
    constexpr double kAlike = 0.01;  // of the largest variance
    if (balls.size() < 2) return {1, 0, 0, 0};
    const glm::dvec3 mean = computeMean(balls);
    const PrincipalAxes axes = findAxes(balls, mean);
    const auto alike = [&](std::size_t i, std::size_t j) {
        return axes.values[i] - axes.values[j] < kAlike * axes.values[0];
    };
    const bool longIsOne = !alike(0, 1), shortIsOne = !alike(1, 2);
    if (!longIsOne && !shortIsOne) return {1, 0, 0, 0};
    glm::dvec3 longest, depth;
    if (longIsOne) {
        longest = directed(axes.ways[0], balls, mean);
        depth = shortIsOne ? directed(axes.ways[2], balls, mean) : acrossFrom(longest, 2);
    } else {
        depth = directed(axes.ways[2], balls, mean);
        longest = acrossFrom(depth, wide ? 0 : 1);
    }
    const glm::dvec3 x = wide ? longest : glm::cross(longest, depth);
    const glm::dvec3 y = wide ? glm::cross(depth, longest) : longest;
    return glm::normalize(glm::quat_cast(glm::transpose(glm::dmat3(x, y, depth))));
}

bool isSlab(const std::vector<glm::dvec4>& balls) {
    constexpr double kThin = 0.4;  // relative to the next variance: 63 % of the spread
    if (balls.size() < 3) return false;
    const PrincipalAxes axes = findAxes(balls, computeMean(balls));
    return axes.values[2] < kThin * axes.values[1];
}

glm::dquat edgeOnOrientation(const std::vector<glm::dvec4>& slab) {
    const glm::dvec3 mean = computeMean(slab);
    const PrincipalAxes axes = findAxes(slab, mean);
    const glm::dvec3 up = directed(axes.ways[2], slab, mean), right = directed(axes.ways[0], slab, mean);
    return glm::normalize(glm::quat_cast(glm::transpose(glm::dmat3(right, up, glm::cross(right, up)))));
}

/// How much of the picture a target covers, seen along each direction: the area of its spread's ellipse.
std::vector<double> measureBreadths(const Balls& target, const std::vector<glm::dvec3>& ways) {
    constexpr double kAtom = 1;  // Å², of a single atom
    const glm::dvec3 middle = computeMean(target);
    glm::dmat3 spread(0.0);
    for (const glm::dvec4& ball : target) {
        const glm::dvec3 off = glm::dvec3(ball) - middle;
        spread += glm::outerProduct(off, off) / static_cast<double>(target.size());
    }
    std::vector<double> breadths;
    for (const glm::dvec3& way : ways) {
        const glm::dvec3 u = acrossFrom(way, 0), v = glm::cross(way, u);
        const double uu = glm::dot(u, spread * u) + kAtom, vv = glm::dot(v, spread * v) + kAtom;
        const double uv = glm::dot(u, spread * v);
        breadths.push_back(std::sqrt(std::max(uu * vv - uv * uv, 0.0)));
    }
    return breadths;
}

glm::dquat facingOrientation(const std::vector<glm::dvec4>& target, const std::vector<glm::dvec4>& all,
                             const glm::dmat3& from) {
    constexpr std::size_t kDirections = 400, kMostTargets = 48;
    constexpr double kOutward = 0.15, kSharpness = 12;  // weight of the outward direction; a cone of about 20 degrees
    constexpr double kNarrow = 0.5;                     // weight of a target seen edge-on
    const glm::dvec3 viewer = glm::transpose(from) * glm::dvec3(0, 0, 1);
    const glm::dvec3 middle = computeMean(target), out = middle - computeMean(all);
    const glm::dvec3 outward = glm::length(out) > 0.5 ? glm::normalize(out) : viewer;
    const std::vector<glm::dvec3> ways = directionsAround(kDirections);
    const std::vector<double> open = openShares(takeSample(target, kMostTargets), without(all, target), ways);
    glm::dvec3 best = viewer;
    double most = -1;
    const std::vector<double> breadths = measureBreadths(target, ways);
    const double broadest = *std::max_element(breadths.begin(), breadths.end());
    for (std::size_t w = 0; w < ways.size(); ++w) {
        const glm::dvec3& way = ways[w];
        double sum = 0, weights = 0;  // a single slit between two atoms is no opening
        for (std::size_t i = 0; i < ways.size(); ++i) {
            const double near = std::pow(std::max(glm::dot(way, ways[i]), 0.0), kSharpness);
            sum += near * open[i];
            weights += near;
        }
        const double seen = sum / weights * (kNarrow + (1 - kNarrow) * breadths[w] / broadest);
        const double score = seen + kOutward * glm::dot(way, outward);
        if (score > most) most = score, best = way;
    }
    // The shortest rotation that turns `best` from its current direction to the viewer.
    const glm::dvec3 now = from * best;
    const glm::dvec3 axis = glm::cross(now, glm::dvec3(0, 0, 1));
    const double sine = glm::length(axis), angle = std::atan2(sine, now.z);
    const glm::dquat turn = sine > 1e-9 ? glm::angleAxis(angle, axis / sine)
                                        : glm::angleAxis(angle, glm::dvec3(0, 1, 0));  // half a turn, or none
    return glm::normalize(turn * glm::quat_cast(from));
}

Camera closeUp(Camera camera, const std::vector<glm::dvec4>& target, double radius, double margin, double mostZoom) {
    const Bounds bounds = computeBounds(target);
    camera.scale.reset();
    camera.eyeDistance.reset();
    const View view = makeView(camera, radius, 1000, 1000);
    const glm::dvec3 middle = view.rotation * bounds.center;
    const double magnify =
        view.projection == Projection::perspective ? view.eyeDistance / (view.eyeDistance - middle.z) : 1.0;
    camera.pan = -glm::dvec2(middle) * magnify;
    camera.zoom = std::min(camera.zoom * radius / ((bounds.radius + margin) * magnify), mostZoom);
    return camera;
}

Camera fitted(Camera camera, const Representation& scene, const Representation* beside, double radius,
              std::uint32_t width, std::uint32_t height, double mostZoom) {
    constexpr double kFill = 0.95, kMost = 1e7;
    if (drawnBallCount(scene) > kMost || (camera.center && camera.scale)) return camera;
    const View view = makeView(camera, radius, width, height);
    const bool perspective = view.projection == Projection::perspective;
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
    const auto hold = [&](const glm::dvec4& ball) {
        const glm::dvec3 v = view.rotation * glm::dvec3(ball);
        const double magnify = perspective ? view.eyeDistance / (view.eyeDistance - v.z) : 1.0;
        low = glm::min(low, (glm::dvec2(v) - ball.w) * magnify);
        high = glm::max(high, (glm::dvec2(v) + ball.w) * magnify);
    };
    eachDrawnBall(scene, hold);
    if (beside) eachBallBeside(*beside, hold);
    if (low.x > high.x) return camera;
    if (camera.center) low = glm::min(low, -high), high = -low;
    const glm::dvec2 extent = glm::max(high - low, glm::dvec2(1e-6));
    camera.pan = -(low + high) / 2.0;
    if (camera.scale) return camera;
    const double more = std::min(width / extent.x, height / extent.y) * kFill / view.pixelsPerAngstrom;
    camera.zoom = std::min(camera.zoom * more * camera.zoom, mostZoom);
    return camera;
}

double hiddenShare(const std::vector<glm::dvec4>& target, const std::vector<glm::dvec4>& all,
                   const glm::dmat3& rotation) {
    // Å: vertices of a surface or cartoon are so dense that they leave no gaps
    constexpr double kVertexReach = 0.6;
    constexpr std::size_t kMostAsked = 1000;
    Balls seen = takeSample(target, kMostAsked);
    const std::size_t asked = seen.size();
    if (asked == 0) return 0;
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
    for (glm::dvec4& ball : seen) {
        ball = glm::dvec4(rotation * glm::dvec3(ball), ball.w);
        low = glm::min(low, glm::dvec2(ball));
        high = glm::max(high, glm::dvec2(ball));
    }
    for (const glm::dvec4& other : without(all, target)) {
        const double reach = other.w > 0 ? other.w : kVertexReach;
        const glm::dvec3 at = rotation * glm::dvec3(other);
        // Most of a large scene is outside the target's picture.
        if (at.x < low.x - reach || at.y < low.y - reach || at.x > high.x + reach || at.y > high.y + reach) continue;
        std::erase_if(seen, [&](const glm::dvec4& ball) {
            const glm::dvec2 way = glm::dvec2(at) - glm::dvec2(ball);
            return glm::dot(way, way) < reach * reach && at.z - ball.z > ball.w;
        });
    }
    return static_cast<double>(asked - seen.size()) / static_cast<double>(asked);
}

glm::dmat3 findPrincipalAxes(std::span<const glm::dvec3> points) {
    Balls balls;
    for (const glm::dvec3& point : points) balls.emplace_back(point, 0.0);
    const PrincipalAxes axes = findAxes(balls, computeMean(balls));
    return {axes.ways[0], axes.ways[1], axes.ways[2]};
}

}  // namespace nacre
