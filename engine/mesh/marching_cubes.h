#pragma once
// How a surface passes through a cell of a grid whose corners are inside or outside.

#include <array>
#include <cstdint>
#include <vector>

namespace nacre {

/// Corner c of a cell stands at (c & 1, c >> 1 & 1, c >> 2 & 1).
constexpr int kCellCorners = 8, kCellEdges = 12;

/// Corners at the ends of a cell's edge; the first has the smaller number.
struct CellEdge {
    std::uint8_t from = 0, to = 0;
};
const std::array<CellEdge, kCellEdges>& cellEdges();

/// Edges that each corner of a triangle lies on, counter-clockwise seen from outside.
using CellTriangle = std::array<std::uint8_t, 3>;

/// For each of the 256 ways in which a cell's corners can be inside (bit c of the index), its triangles. After W.
/// Lorensen and H. Cline (1987), made by walking around the faces; where a face has two opposite corners inside they
/// are parted, in both cells that share it, so that surfaces are closed whatever the field is.
const std::array<std::vector<CellTriangle>, 256>& cellTriangles();

}  // namespace nacre
