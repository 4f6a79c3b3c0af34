#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace nacre {

enum class Projection { orthographic, perspective };

/// An absolute scale of the image plane, independent of the drawn scene.
struct ViewScale {
    enum class Unit {
        pixelsPerAngstrom,
        angstromAcross,  ///< width of the picture's shorter side, Å
    };
    Unit unit = Unit::angstromAcross;
    double value = 1;
    friend bool operator==(const ViewScale&, const ViewScale&) = default;
};

/// Camera settings of the user. Without `center` and `scale` the camera depends on the drawn scene.
struct Camera {
    Projection projection = Projection::orthographic;
    glm::dvec3 rotationDegrees{0.0};      ///< right-handed, about the view axes, x first: v = Rz Ry Rx Q (p - C)
    glm::dquat orientation{1, 0, 0, 0};   ///< Q, a unit quaternion, for uses without the three angles
    glm::dvec2 pan{0.0};                  ///< position of C on the image plane, Å from the picture's centre
    double zoom = 1.0;                    ///< scales the image plane
    double fovDegrees = 30.0;             ///< perspective: field of view across the shorter side
    std::optional<glm::dvec3> center{};   ///< C, Å in the file's frame; empty: of the drawn scene
    std::optional<ViewScale> scale{};     ///< at zoom 1, on the plane through C; empty: the bounding sphere fills it
    std::optional<double> eyeDistance{};  ///< perspective: Å from C; empty: computed from the bounding sphere

    /// Whether position or scale are given.
    bool isPlaced() const { return zoom != 1 || pan != glm::dvec2(0) || center || scale; }
};

/// The view of one picture. View space: origin at the molecule's centre, +x right, +y up, +z to the viewer, Å. Pixel
/// (i, j), row 0 on top, sees x = (i + 0.5 - width / 2) / pixelsPerAngstrom - pan.x, y = (height / 2 - j - 0.5) /
/// pixelsPerAngstrom - pan.y on the plane z = 0; in perspective from the eye (0, 0, eyeDistance), so that panning acts
/// like a shift lens.
struct View {
    std::uint32_t width = 0, height = 0;  ///< of the upright picture
    Projection projection = Projection::orthographic;
    glm::dmat3 rotation{1.0};        ///< column-major as in GLM: v = rotation * (p - C) + shift
    double radius = 1.0;             ///< R: bounding sphere about the origin, Å
    double eyeDistance = 0.0;        ///< Å; 0 if orthographic
    double pixelsPerAngstrom = 1.0;  ///< at z = 0
    glm::dvec2 pan{0.0};             ///< Å
    glm::dvec3 shift{0.0};           ///< translation after the rotation, Å: for an eye beside the view axis
    /// If this is the left one of two eyes' views: differences of the right one.
    struct OtherEye {
        double shift = 0, pan = 0;  ///< added to shift.x and pan.x
    };
    std::optional<OtherEye> other{};
    int quarterTurns = 0;  ///< 0..3: clockwise quarter turns of the picture in the image (pre-rotation)

    /// Transforms a point of the scene, relative to C, to view space.
    glm::dvec3 seen(const glm::dvec3& p) const { return rotation * p + shift; }
};

glm::dmat3 rotationMatrix(const glm::dvec3& degrees);

/// Orthographic: the sphere (C, R) fills 95 % of the shorter side at zoom 1. Perspective: the eye is at R / (0.95
/// sin(fov / 2)) and zoom scales the image plane. A scale or eye distance of the camera replaces these; the eye stays
/// outside the sphere.
View makeView(const Camera& camera, double radius, std::uint32_t width, std::uint32_t height);

/// The camera of a view, independent of the drawn scene: makeView() returns the same view for any radius.
/// @param center  of the view's scene, Å in the file's frame
Camera absoluteCamera(const View& view, double fovDegrees, const glm::dvec3& center);

/// The same camera, with zoom and radius instead of scale and eye distance. @param radius  of the scene, Å; becomes the
/// one from which makeView() computes the eye
Camera relativeCamera(Camera camera, double& radius);

/// The view of an eye beside the axis of a perspective view: parallel to it, with a shifted frustum.
/// @param aside  Å to the right @param screen  Å from the eyes: points at this distance stay where they are
View fromAside(View view, double aside, double screen);

/// The left eye's view with the right one's difference (View::other), so that one frame can draw both.
View paired(View left, const View& right);
/// The right eye's view alone. @param view  has View::other
View otherView(View view);

/// The same picture with `factor` times the pixels per side, at least one.
View scaled(View view, double factor);

/// The view of a rectangle of the picture. @param x, y  its top left corner, pixels
View cropView(View view, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height);

/// The point on the image plane (Å, before pan) at a point of the picture. @param x, y pixels from the top left
glm::dvec2 planePointAt(const View& view, double x, double y);

}  // namespace nacre
