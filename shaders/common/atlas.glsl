#ifndef NACRE_ATLAS_GLSL
#define NACRE_ATLAS_GLSL
// Position of a primitive's patch in the occlusion atlas: rows of spheres' patches, then of cylinders', then mesh
// vertices, two texels each (engine/occlusion/atlas_layout.h). Computed from the primitive's number, so that no stream
// stores it. An atlas has fewer rows than 2^20.
#include "divide.glsl"
#include "view.glsl"

/// Rows needed for `patches` patches, `inRow` per row.
uint countRows(uint patches, uint inRow) { return dividedSmall(patches + inRow - 1u, inRow).x; }
uint sphereEdge() { return view.patchTexels & 0xffu; }
uvec2 cylinderTexels() { return uvec2(view.patchTexels >> 8 & 0xffu, view.patchTexels >> 16 & 0xffu); }

/// Column of a sphere's patch | its row << 16: fragments find the sphere and its patch without a division.
/// @param index  within its copy
uint sphereCell(uint index) {
    uvec2 at = dividedSmall(index, view.patchesInRow & 0xffffu);
    return at.y | at.x << 16;
}
uint sphereOfCell(uint cell) { return (cell >> 16) * (view.patchesInRow & 0xffffu) + (cell & 0xffffu); }
/// First texel of the patch of a sphere, x | y << 16. @param index  within its copy
uint spherePatch(uint index) { return sphereCell(index) * sphereEdge(); }
uint cylinderPatch(uint index) {
    uint top = countRows(view.spheres, view.patchesInRow & 0xffffu) * sphereEdge();
    uvec2 at = dividedSmall(index, view.patchesInRow >> 16).yx * cylinderTexels();
    return at.x | (at.y + top) << 16;
}

// With kCells shaders interpolate occlusion, from cells or, with kBounce, from texels; otherwise the sampler does.
layout(constant_id = kCellsId) const bool kCells = false;

/// Position of a patch for a look-up: its first texel or, for the sampler, its coordinate.
vec2 placeOfTexel(vec2 corner) {
    precise vec2 coordinate = (corner + 0.5) * view.atlasTexel;
    return kCells ? corner : coordinate;
}
vec2 patchPlace(uint address) { return placeOfTexel(vec2(address & 0xffffu, address >> 16)); }
vec2 placeOfCell(uint cell) { return placeOfTexel(vec2(cell & 0xffffu, cell >> 16) * float(sphereEdge())); }

/// Position of a vertex's texel. @param side  0 outer, 1 inner @param cylinders  with patches
ivec2 vertexPlace(uint vertex, uint side, uint cylinders) {
    uint top = countRows(view.spheres, view.patchesInRow & 0xffffu) * sphereEdge() +
               countRows(cylinders, view.patchesInRow >> 16) * cylinderTexels().y;
    uvec2 at = dividedSmall(2u * vertex + side, uint(1.0 / view.atlasTexel.x + 0.5));
    return ivec2(at.y, at.x + top);
}
#endif
