#pragma once
// Geometry in addition to atoms: lines, tubes, arrows, spheres, ellipsoids, ellipses, boxes, meshes and labels at
// points. Every visibility path draws it. It occludes, casts shadows and is clipped like atoms, and exports include it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/color/palettes.h"
#include "engine/scene/view/bounds.h"

namespace nacre {

struct Representation;

/// Look of a primitive, and its note.
struct PrimitiveLook {
    std::uint32_t color = packedColor(0xc8c8c8);  ///< packed as in colors.h, opaque
    double opacity = 1;                           ///< kLeastOpacity to 1; lines of constant width are opaque
    std::uint32_t note = 0;                       ///< 1-based index into Primitives::notes; 0: none
};

/// Dashes along a line, Å. Scaled so that the line begins and ends with half a gap.
struct PrimitiveDashes {
    double dash = 0, gap = 0;  ///< a dash of 0: no dashes
    bool any() const { return dash > 0 && gap > 0; }
};

/// All positions are Å in the file's frame. Primitives without extent, or not finite, are not drawn.
struct Primitives {
    /// Exact: a cylinder with flat ends, or a line of constant screen width.
    struct Line {
        glm::dvec3 a{}, b{};
        double radius = 0;   ///< Å; 0: use `width`
        double width = 1.5;  ///< pixels
        PrimitiveDashes dashes{};
        PrimitiveLook look{};
    };
    /// A tube whose heads are cones of kRoundSides sides within its length.
    struct Arrow {
        glm::dvec3 from{}, to{};
        double radius = 0.05, headRadius = 0.12, headLength = 0.3;  ///< Å; a tube radius of 0: heads only
        bool headAtFrom = false, headAtTo = true;
        PrimitiveDashes dashes{};
        PrimitiveLook look{};
    };
    /// Exact if opaque, else an ellipsoid.
    struct Ball {
        glm::dvec3 center{};
        double radius = 1;  ///< Å
        PrimitiveLook look{};
    };
    /// The unit sphere under a linear map: a mesh with an error of ellipsoidError().
    struct Ellipsoid {
        glm::dvec3 center{};
        std::array<glm::dvec3, 3> axes{};  ///< half axes, Å; they may be oblique
        PrimitiveLook look{};
    };
    /// A flat sector between two angles: center + cos(t) major + sin(t) minor. Visible from both sides.
    struct Ellipse {
        glm::dvec3 center{}, major{}, minor{};
        double start = 0, end = 6.283185307179586;  ///< radians
        PrimitiveLook look{};
    };
    struct Box {
        glm::dvec3 center{};
        std::array<glm::dvec3, 3> axes{};  ///< from the centre to the centres of three faces, Å
        std::optional<PrimitiveLook> faces = PrimitiveLook{}, edges = {};
        double edgeRadius = 0.1;  ///< Å; 0: lines of `edgeWidth`
        double edgeWidth = 1.5;   ///< pixels
    };
    /// Triangles, visible from both sides.
    struct Mesh {
        std::vector<glm::dvec3> positions;
        std::vector<std::array<std::uint32_t, 3>> triangles;
        /// One for all, one per triangle or one per vertex: a point takes the look of the nearest vertex.
        std::vector<PrimitiveLook> looks{{}};
        bool blends = false;                   ///< looks are of vertices, whose colours blend in between
        bool smooth = false;                   ///< vertex normals are means over triangles; false: flat triangles
        std::optional<PrimitiveLook> wires{};  ///< if set, its edges are drawn as lines
        double wireWidth = 1;                  ///< pixels
        bool faces = true;
    };
    /// Where a label with a size lies, and what is behind it.
    struct LabelPlate {
        /// Side of its point on which the text lies, to the right and up: 1, 0 (centred) or -1.
        glm::ivec2 side{0, 0};
        double tether = 0;        ///< em; length of a wedge from the point to the text, if that lies beside it
        std::uint32_t color = 0;  ///< packed; of the wedge and of the background
        bool background = false;
        friend bool operator==(const LabelPlate&, const LabelPlate&) = default;
    };
    struct Label {
        glm::dvec3 at{};
        std::string text;                      ///< with the markup of labels
        double size = 0;                       ///< em size in Å, at `at`; 0: that of all labels
        std::optional<std::uint32_t> color{};  ///< packed; empty: that of all labels
        LabelPlate plate{};
    };

    std::vector<Line> lines;
    std::vector<Arrow> arrows;
    std::vector<Ball> balls;
    std::vector<Ellipsoid> ellipsoids;
    std::vector<Ellipse> ellipses;
    std::vector<Box> boxes;
    std::vector<Mesh> meshes;
    std::vector<Label> labels;
    std::vector<std::string> notes;  ///< shown for a primitive under the pointer in a window

    bool empty() const;
    /// Appends other primitives, and renumbers their notes.
    void append(Primitives others);
};

constexpr int kRoundSides = 48;  ///< around cones, translucent tubes and full ellipses: within 0.0022 radii
constexpr std::size_t kMostPrimitives = 1'000'000, kMostPrimitiveTriangles = 20'000'000;
constexpr double kFarthestPrimitive = 1e6;  ///< Å along each axis

/// Whether each triangle of a mesh has a look of its own.
inline bool hasLooksOfTriangles(const Primitives::Mesh& mesh) {
    return !mesh.blends && mesh.looks.size() > 1 && mesh.looks.size() == mesh.triangles.size();
}

/// Error bound of an ellipsoid's mesh, relative to its longest half axis. @param count  drawn together: 2.4e-4 up to
/// 61, then 9.8e-4 (244), 3.9e-3 (976), 0.015 (3906), and 0.057
double ellipsoidError(std::size_t count);

/// Bounding sphere; empty if nothing is drawn. Labels count as points.
std::optional<Bounds> computeBounds(const Primitives& primitives);

/// Points on the outlines of primitives, without labels: corners, and points on round shapes.
std::vector<glm::dvec4> outlinePoints(const Primitives& primitives);

/// Adds primitives to a scene, about its centre; increases its radius. Their numbers are those of their notes.
/// @throws Error if there are too many, they are too far away, or cover each other too often
void addPrimitives(const Primitives& primitives, Representation& scene);

}  // namespace nacre
