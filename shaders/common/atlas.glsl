// Where the patch of a primitive lies in the occlusion atlas: rows of spheres' patches, then rows of cylinders'
// (engine/occlusion/atlas_layout.h). It follows from the primitive's number, so that no stream says it.
#include "divide.glsl"
#include "view.glsl"

uint sphereEdge() { return view.patchTexels & 0xffu; }
uvec2 cylinderTexels() { return uvec2(view.patchTexels >> 8 & 0xffu, view.patchTexels >> 16 & 0xffu); }

/// First texel of the patch of a sphere, x | y << 16. @param index  within its copy
uint spherePatch(uint index) {
    uvec2 at = divided(index, view.patchesInRow & 0xffffu);
    return (at.y | at.x << 16) * sphereEdge();
}
uint cylinderPatch(uint index) {
    uint spherePatches = view.patchesInRow & 0xffffu;
    uint top = (view.spheres + spherePatches - 1u) / spherePatches * sphereEdge();
    uvec2 at = divided(index, view.patchesInRow >> 16).yx * cylinderTexels();
    return at.x | (at.y + top) << 16;
}
