// Position of a primitive's patch in the occlusion atlas: rows of spheres' patches, then of cylinders', then mesh
// vertices, two texels each (engine/occlusion/atlas_layout.h). Computed from the primitive's number, so that no stream
// stores it. An atlas has fewer rows than 2^20.
#include "divide.glsl"
#include "view.glsl"

/// Rows of `inRow` patches that `patches` take.
uint rowsOf(uint patches, uint inRow) { return dividedSmall(patches + inRow - 1u, inRow).x; }
uint sphereEdge() { return view.patchTexels & 0xffu; }
uvec2 cylinderTexels() { return uvec2(view.patchTexels >> 8 & 0xffu, view.patchTexels >> 16 & 0xffu); }

/// First texel of the patch of a sphere, x | y << 16. @param index  within its copy
uint spherePatch(uint index) {
    uvec2 at = dividedSmall(index, view.patchesInRow & 0xffffu);
    return (at.y | at.x << 16) * sphereEdge();
}
uint cylinderPatch(uint index) {
    uint top = rowsOf(view.spheres, view.patchesInRow & 0xffffu) * sphereEdge();
    uvec2 at = dividedSmall(index, view.patchesInRow >> 16).yx * cylinderTexels();
    return at.x | (at.y + top) << 16;
}

// Shaders interpolate occlusion themselves, as its cells are: else the sampler does.
layout(constant_id = kCellsId) const bool kCells = false;

/// A patch by its address, as shaders look it up: its first texel or, for the sampler, that texel's coordinate.
vec2 patchPlace(uint address) {
    precise vec2 corner = vec2(address & 0xffffu, address >> 16);
    precise vec2 coordinate = (corner + 0.5) * view.atlasTexel;
    return kCells ? corner : coordinate;
}

/// patchPlace() of a sphere's patch, in fewer steps, for fewer than 2^23 spheres.
vec2 spherePlace(uint index) {
    float inRow = float(view.patchesInRow & 0xffffu);
    precise float row = floor(float(index) / inRow);
    precise float column = fma(-row, inRow, float(index));
    float off = column < 0.0 ? -1.0 : column >= inRow ? 1.0 : 0.0;
    precise vec2 corner = vec2(column - off * inRow, row + off) * float(sphereEdge());
    precise vec2 coordinate = (corner + 0.5) * view.atlasTexel;
    return kCells ? corner : coordinate;
}

/// Where a vertex's texel stands. @param side  0 the outer one, 1 the inner one @param cylinders  that have patches
ivec2 vertexPlace(uint vertex, uint side, uint cylinders) {
    uint top = rowsOf(view.spheres, view.patchesInRow & 0xffffu) * sphereEdge() +
               rowsOf(cylinders, view.patchesInRow >> 16) * cylinderTexels().y;
    uvec2 at = dividedSmall(2u * vertex + side, uint(1.0 / view.atlasTexel.x + 0.5));
    return ivec2(at.y, at.x + top);
}
