// Vertices of meshes, as streams store them (engine/scene/build/mesh_streams.h).
#ifndef NACRE_VERTEX_GLSL
#define NACRE_VERTEX_GLSL
#include "patch.glsl"

/// Position of a vertex, in its triangles' steps: integers below 2^21 times a power of two, so exact.
vec3 vertexPosition(uvec4 vertex, float step) {
    uvec3 at = uvec3(vertex.xy & 0x1fffffu, vertex.x >> 21 | vertex.y >> 21 << 11);
    return fma(vec3(at), vec3(step), vec3(-1048576.0 * step));  // exact, like the difference
}
/// @param packed  word w of a triangle: above the weights of its corners (Triangle of mesh_streams.h)
float unpackStep(uint packed) { return uintBitsToFloat(packed & ~0x1fffffu); }
/// @param packed  word z of a vertex
vec3 vertexNormal(uint packed) {
    return octahedralNormal(vec2(packed & 0xffffu, packed >> 16) * (1.0 / 65535.0));
}
#endif
