#pragma once
// Geometry beside the atoms: lines, tubes, arrows, spheres, ellipsoids, ellipses, boxes, meshes and labels at points.
// Every visibility path draws them, they occlude, throw shadows and are cut like atoms, and exports have them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/bounds.h"
#include "engine/scene/palettes.h"

namespace nacre {

struct Representation;

/// How a primitive looks, and which note it has.
struct PrimitiveLook {
    std::uint32_t color = packedColor(0xc8c8c8);  ///< as colors.h packs it, opaque
    double opacity = 1;                           ///< kLeastOpacity to 1; lines of constant width are opaque
    std::uint32_t note = 0;                       ///< which of Primitives::notes, counted from 1; 0: none
};

/// Dashes along a line, Å. They are stretched or shrunk so that the line begins and ends with half a gap.
struct PrimitiveDashes {
    double dash = 0, gap = 0;  ///< a dash of 0: no dashes
    bool any() const { return dash > 0 && gap > 0; }
};

/// All places are Å in the file's frame. What has no extent or is not finite is not drawn.
struct Primitives {
    /// Exact: a cylinder with flat ends, or a line of constant width in the picture.
    struct Line {
        glm::dvec3 a{}, b{};
        double radius = 0;   ///< Å; 0: `width` holds
        double width = 1.5;  ///< pixels
        PrimitiveDashes dashes{};
        PrimitiveLook look{};
    };
    /// A tube whose heads are cones of kRoundSides sides within its length.
    struct Arrow {
        glm::dvec3 from{}, to{};
        double radius = 0.05, headRadius = 0.12, headLength = 0.3;  ///< Å; a tube radius of 0: heads alone
        bool headAtFrom = false, headAtTo = true;
        PrimitiveDashes dashes{};
        PrimitiveLook look{};
    };
    /// Exact where it is opaque, else an ellipsoid.
    struct Ball {
        glm::dvec3 center{};
        double radius = 1;  ///< Å
        PrimitiveLook look{};
    };
    /// The unit sphere under a linear map: a mesh within ellipsoidError() of it.
    struct Ellipsoid {
        glm::dvec3 center{};
        std::array<glm::dvec3, 3> axes{};  ///< half axes, Å; they may be oblique
        PrimitiveLook look{};
    };
    /// A flat sector between two angles: center + cos(t) major + sin(t) minor. Seen from both sides.
    struct Ellipse {
        glm::dvec3 center{}, major{}, minor{};
        double start = 0, end = 6.283185307179586;  ///< radians
        PrimitiveLook look{};
    };
    struct Box {
        glm::dvec3 center{};
        std::array<glm::dvec3, 3> axes{};  ///< from the centre to the middles of three faces, Å
        std::optional<PrimitiveLook> faces = PrimitiveLook{}, edges = {};
        double edgeRadius = 0.1;  ///< Å; 0: lines of `edgeWidth`
        double edgeWidth = 1.5;   ///< pixels
    };
    /// Triangles, seen from both sides.
    struct Mesh {
        std::vector<glm::dvec3> positions;
        std::vector<std::array<std::uint32_t, 3>> triangles;
        /// One for all, one per triangle or one per vertex: a point takes that of the vertex next to it.
        std::vector<PrimitiveLook> looks{{}};
        bool smooth = false;  ///< normals are means over the triangles of a vertex; else each triangle is flat
        std::optional<PrimitiveLook> wires{};  ///< its edges as lines
        double wireWidth = 1;                  ///< pixels
        bool faces = true;
    };
    struct Label {
        glm::dvec3 at{};
        std::string text;                      ///< with the markup of labels
        double size = 0;                       ///< Å of an em, as it is seen at `at`; 0: as large as all labels
        std::optional<std::uint32_t> color{};  ///< packed; empty: as all labels
    };

    std::vector<Line> lines;
    std::vector<Arrow> arrows;
    std::vector<Ball> balls;
    std::vector<Ellipsoid> ellipsoids;
    std::vector<Ellipse> ellipses;
    std::vector<Box> boxes;
    std::vector<Mesh> meshes;
    std::vector<Label> labels;
    std::vector<std::string> notes;  ///< what a window says of a primitive under the pointer, plain text

    bool empty() const;
    /// Puts others behind these. Their notes are numbered on.
    void append(Primitives others);
};

constexpr int kRoundSides = 48;  ///< around cones, translucent tubes and full ellipses: within 0.0022 radii
constexpr std::size_t kMostPrimitives = 1'000'000, kMostPrimitiveTriangles = 20'000'000;
constexpr double kFarthestPrimitive = 1e6;  ///< Å along each axis

/// How far an ellipsoid's mesh stands off it at most, in its longest half axis. @param count  that are drawn together:
/// 2.4e-4 up to 61, then 9.8e-4 (244), 3.9e-3 (976), 0.015 (3906), and 0.057
double ellipsoidError(std::size_t count);

/// Bounding sphere; empty if nothing is drawn. Labels count as points.
std::optional<Bounds> boundsOf(const Primitives& primitives);

/// Draws primitives beside what a scene has, about its centre; its radius grows. Their numbers are those of their
/// notes.
/// @throws Error if they are too many, too far away, or cover each other too often
void addPrimitives(const Primitives& primitives, Representation& scene);

}  // namespace nacre
