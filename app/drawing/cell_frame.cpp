#include "app/drawing/cell_frame.h"

#include "app/annotation/placed_words.h"
#include "engine/molecule/crystal.h"

namespace nacre::app {

Primitives cellFrame(const Molecule& molecule) {
    constexpr std::uint32_t kEdge = packedColor(0x707070);
    constexpr const char* kNames[] = {"a", "b", "c"};
    constexpr double kEdgeWidth = 1.5, kAxisWidth = 3, kBeyond = 0.04;  // pixels, pixels, of the edge

    Primitives frame;
    const auto edges = cellEdges(molecule.file);
    if (!edges) return frame;
    const glm::dvec3 corner = cellCorner(molecule);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t side = 0; side < 4; ++side) {
            glm::dvec3 from = corner;
            if (side & 1) from += (*edges)[(axis + 1) % 3];
            if (side & 2) from += (*edges)[(axis + 2) % 3];
            Primitives::Line line{from, from + (*edges)[axis]};
            line.width = side == 0 ? kAxisWidth : kEdgeWidth;
            line.look.color = side == 0 ? kAxisColors[axis] : kEdge;
            frame.lines.push_back(line);
        }
    for (std::size_t axis = 0; axis < 3; ++axis)
        frame.labels.push_back({corner + (1 + kBeyond) * (*edges)[axis], kNames[axis], 0, kAxisColors[axis]});
    return frame;
}

}  // namespace nacre::app
