#include "engine/scene/view/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

constexpr double kFill = 0.95;  // fraction of the shorter side that the bounding sphere fills

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// Sine and cosine, exact at multiples of 90 degrees so that quarter turns stay crisp.
struct Turn {
    double sine, cosine;
    explicit Turn(double degrees) {
        const double quarter = std::remainder(degrees, 360.0) / 90.0;
        if (quarter == std::floor(quarter)) {
            constexpr double kSine[] = {0, 1, 0, -1};
            const int q = (static_cast<int>(quarter) + 4) % 4;
            sine = kSine[q];
            cosine = kSine[(q + 1) % 4];
        } else {
            sine = std::sin(radians(degrees));
            cosine = std::cos(radians(degrees));
        }
    }
};

/// Distance at which the bounding sphere fills the picture.
double computeEyeDistance(const Camera& camera, double radius) {
    return radius / (kFill * std::sin(radians(camera.fovDegrees) / 2.0));
}

}  // namespace

glm::dmat3 rotationMatrix(const glm::dvec3& degrees) {
    const Turn x(degrees.x), y(degrees.y), z(degrees.z);
    // GLM is column-major: each triple below is a column of the matrix.
    const glm::dmat3 rx(1, 0, 0, 0, x.cosine, x.sine, 0, -x.sine, x.cosine);
    const glm::dmat3 ry(y.cosine, 0, -y.sine, 0, 1, 0, y.sine, 0, y.cosine);
    const glm::dmat3 rz(z.cosine, z.sine, 0, -z.sine, z.cosine, 0, 0, 0, 1);
    return rz * ry * rx;
}

View makeView(const Camera& camera, double radius, std::uint32_t width, std::uint32_t height) {
    View view;
    view.width = width;
    view.height = height;
    view.projection = camera.projection;
    view.rotation = rotationMatrix(camera.rotationDegrees) * glm::mat3_cast(camera.orientation);
    view.pan = camera.pan;
    view.radius = radius;
    const double shorter = std::min(width, height);
    if (camera.projection == Projection::orthographic) {
        view.pixelsPerAngstrom = kFill * shorter / (2.0 * radius);
    } else {
        constexpr double kNearest = 1.02;  // minimum distance of the eye, relative to the radius
        const double half = radians(camera.fovDegrees) / 2.0;
        view.eyeDistance = computeEyeDistance(camera, radius);
        if (camera.eyeDistance) view.eyeDistance = std::max(*camera.eyeDistance, radius * kNearest);
        view.pixelsPerAngstrom = shorter / (2.0 * view.eyeDistance * std::tan(half));
    }
    if (camera.scale)
        view.pixelsPerAngstrom = camera.scale->unit == ViewScale::Unit::pixelsPerAngstrom
                                     ? camera.scale->value
                                     : shorter / camera.scale->value;
    view.pixelsPerAngstrom *= camera.zoom;
    return view;
}

Camera absoluteCamera(const View& view, double fovDegrees, const glm::dvec3& center) {
    Camera camera;
    camera.projection = view.projection;
    camera.orientation = glm::normalize(glm::quat_cast(view.rotation));
    camera.pan = view.pan;
    camera.fovDegrees = fovDegrees;
    camera.center = center;
    camera.scale = {ViewScale::Unit::angstromAcross, std::min(view.width, view.height) / view.pixelsPerAngstrom};
    if (view.projection == Projection::perspective) camera.eyeDistance = view.eyeDistance;
    return camera;
}

Camera relativeCamera(Camera camera, double& radius) {
    constexpr std::uint32_t kAnySize = 1000;
    const View wanted = makeView(camera, radius, kAnySize, kAnySize);
    if (camera.eyeDistance) radius *= wanted.eyeDistance / computeEyeDistance(camera, radius);
    camera.scale.reset();
    camera.eyeDistance.reset();
    camera.zoom = 1;
    camera.zoom = wanted.pixelsPerAngstrom / makeView(camera, radius, kAnySize, kAnySize).pixelsPerAngstrom;
    return camera;
}

View fromAside(View view, double aside, double screen) {
    view.shift.x -= aside;
    view.pan.x += aside * view.eyeDistance / screen;
    return view;
}

View paired(View left, const View& right) {
    left.other = {right.shift.x - left.shift.x, right.pan.x - left.pan.x};
    return left;
}

View otherView(View view) {
    view.shift.x += view.other->shift;
    view.pan.x += view.other->pan;
    view.other.reset();
    return view;
}

View scaled(View view, double factor) {
    const auto side = [&](std::uint32_t pixels) {
        return static_cast<std::uint32_t>(std::max(std::lround(pixels * factor), 1l));
    };
    view.width = side(view.width);
    view.height = side(view.height);
    view.pixelsPerAngstrom *= factor;
    return view;
}

View cropView(View view, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) {
    const glm::dvec2 middle(x + width / 2.0, y + height / 2.0);
    const glm::dvec2 away = middle - glm::dvec2(view.width, view.height) / 2.0;
    view.pan += glm::dvec2(-away.x, away.y) / view.pixelsPerAngstrom;
    view.width = width;
    view.height = height;
    return view;
}

glm::dvec2 planePointAt(const View& view, double x, double y) {
    return glm::dvec2(x - view.width / 2.0, view.height / 2.0 - y) / view.pixelsPerAngstrom - view.pan;
}

}  // namespace nacre
