#include "tests/reference/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <utility>
#include <vector>

namespace nacre::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A rectangle on the plane z = 0, in Å, that a primitive's image lies in.
struct Bounds {
    glm::dvec2 low, high;
};

/// Extent of a ball's image along one axis: its centre stands at `side` across and `ahead` before the eye. The
/// tangents to the circle of radius r in that plane bound it.
void tangents(double side, double ahead, double radius, double eyeDistance, double& low, double& high) {
    if (ahead <= radius) {  // reaches the eye's own plane: no bound
        low = -kInfinity;
        high = kInfinity;
        return;
    }
    const double middle = std::atan2(side, ahead);
    const double half = std::asin(radius / std::hypot(side, ahead));
    low = eyeDistance * std::tan(middle - half);
    high = eyeDistance * std::tan(middle + half);
}

Bounds imageBounds(const View& view, const Ball& ball) {
    const glm::dvec2 center(ball.center.x, ball.center.y);
    if (view.projection == Projection::orthographic) return {center - ball.radius, center + ball.radius};
    Bounds bounds{};
    const double ahead = view.eyeDistance - ball.center.z;
    tangents(center.x, ahead, ball.radius, view.eyeDistance, bounds.low.x, bounds.high.x);
    tangents(center.y, ahead, ball.radius, view.eyeDistance, bounds.low.y, bounds.high.y);
    return bounds;
}

/// A rod lies in the convex hull of the balls about its ends, and so do their images.
Bounds imageBounds(const View& view, const Rod& rod) {
    const Bounds a = imageBounds(view, Ball{rod.a, rod.radius}), b = imageBounds(view, Ball{rod.b, rod.radius});
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

/// First and one past the last pixel whose centre may lie in [low, high], with one pixel to spare for rounding.
struct Run {
    std::uint32_t begin, end;
};
Run pixelRun(double low, double high, std::uint32_t count) {
    const auto clamped = [count](double edge) {
        return static_cast<std::uint32_t>(std::clamp(edge, 0.0, static_cast<double>(count)));
    };
    return {clamped(std::floor(low) - 1.0), clamped(std::ceil(high) + 2.0)};
}

Ball viewBall(const Sphere& sphere, const View& view) {
    return {view.rotation * glm::dvec3(sphere.center), sphere.radius};
}

Rod viewRod(const Cylinder& cylinder, const View& view) {
    return {view.rotation * glm::dvec3(cylinder.a), view.rotation * glm::dvec3(cylinder.b), cylinder.radius};
}

class Canvas {
public:
    explicit Canvas(const View& view)
        : view_(view),
          layers_(emptyLayers(view.width, view.height)),
          nearest_(layers_.pixels(), kInfinity),
          second_(layers_.pixels(), kInfinity) {
        layers_.primitive.assign(layers_.pixels(), kNoPrimitive);
    }

    /// @param atomAt  atom shown where a line enters
    template <typename Solid, typename AtomAt>
    void draw(const Solid& solid, std::uint32_t primitive, AtomAt atomAt) {
        const Bounds bounds = imageBounds(view_, solid);
        const double scale = view_.pixelsPerAngstrom;
        const Run columns = pixelRun(bounds.low.x * scale + view_.width / 2.0 - 0.5,
                                     bounds.high.x * scale + view_.width / 2.0 - 0.5, view_.width);
        const Run rows = pixelRun(view_.height / 2.0 - 0.5 - bounds.high.y * scale,
                                  view_.height / 2.0 - 0.5 - bounds.low.y * scale, view_.height);
        for (std::uint32_t row = rows.begin; row < rows.end; ++row)
            for (std::uint32_t column = columns.begin; column < columns.end; ++column) {
                const Line line = pixelLine(view_, column, row);
                const auto crossing = cross(line, solid);
                if (!crossing || isBehindEye(*crossing)) continue;
                settle(layers_.index(column, row), line, *crossing, primitive, atomAt(*crossing));
            }
    }

    Layers finish() {
        layers_.gap.resize(layers_.pixels());
        layers_.nearEdge.resize(layers_.pixels());
        for (std::uint32_t row = 0; row < layers_.height; ++row)
            for (std::uint32_t column = 0; column < layers_.width; ++column) {
                const std::size_t at = layers_.index(column, row);
                layers_.z[at] = static_cast<float>(nearest_[at]);
                // Background has no surface, so no gap either: infinity - infinity would be NaN.
                layers_.gap[at] = static_cast<float>(second_[at] == kInfinity ? kInfinity : second_[at] - nearest_[at]);
                layers_.nearEdge[at] = anyNeighbor(
                    layers_, column, row, [&](std::size_t neighbor) { return layers_.id[neighbor] != layers_.id[at]; });
            }
        return std::move(layers_);
    }

private:
    /// Orthographic views have no eye: whatever crosses the line is seen, however near.
    bool isBehindEye(const Crossing& crossing) const {
        return view_.projection == Projection::perspective && crossing.enter <= 0.0;
    }

    void settle(std::size_t at, const Line& line, const Crossing& crossing, std::uint32_t primitive,
                std::uint32_t atom) {
        const double depth = -crossing.enter * line.direction.z;
        if (depth >= nearest_[at]) {
            second_[at] = std::min(second_[at], depth);
            return;
        }
        second_[at] = nearest_[at];
        nearest_[at] = depth;
        layers_.id[at] = atom;
        layers_.primitive[at] = primitive;
        layers_.nx[at] = static_cast<float>(crossing.normal.x);
        layers_.ny[at] = static_cast<float>(crossing.normal.y);
        layers_.nz[at] = static_cast<float>(crossing.normal.z);
    }

    const View& view_;
    Layers layers_;
    std::vector<double> nearest_, second_;
};

}  // namespace

Line pixelLine(const View& view, std::uint32_t column, std::uint32_t row) {
    const double x = (column + 0.5 - view.width / 2.0) / view.pixelsPerAngstrom;
    const double y = (view.height / 2.0 - row - 0.5) / view.pixelsPerAngstrom;
    if (view.projection == Projection::orthographic) return {{x, y, view.radius}, {0.0, 0.0, -1.0}};
    return {{0.0, 0.0, view.eyeDistance}, glm::normalize(glm::dvec3(x, y, -view.eyeDistance))};
}

Layers castRays(const Representation& scene, const View& view) {
    Canvas canvas(view);
    std::uint32_t primitive = 0;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const std::uint32_t atom = scene.sphereLooks[i].atom;
        canvas.draw(viewBall(scene.spheres[i], view), primitive++, [atom](const Crossing&) { return atom; });
    }
    for (std::size_t i = 0; i < scene.cylinders.size(); ++i) {
        const CylinderLook& look = scene.cylinderLooks[i];
        canvas.draw(viewRod(scene.cylinders[i], view), primitive++,
                    [&look](const Crossing& crossing) { return crossing.along < 0.5 ? look.atomA : look.atomB; });
    }
    return canvas.finish();
}

std::optional<SurfacePoint> surfacePoint(const Representation& scene, const View& view, const Layers& layers,
                                         std::uint32_t column, std::uint32_t row) {
    const std::uint32_t primitive = layers.primitive[layers.index(column, row)];
    if (primitive == kNoPrimitive) return std::nullopt;
    const Line line = pixelLine(view, column, row);
    const std::size_t spheres = scene.spheres.size();
    const auto crossing = primitive < spheres ? cross(line, viewBall(scene.spheres[primitive], view))
                                              : cross(line, viewRod(scene.cylinders[primitive - spheres], view));
    if (!crossing) return std::nullopt;
    const glm::dmat3 back = glm::transpose(view.rotation);
    return SurfacePoint{primitive, back * (line.origin + crossing->enter * line.direction), back * crossing->normal};
}

}  // namespace nacre::reference
