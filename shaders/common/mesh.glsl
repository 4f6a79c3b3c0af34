// Projection of a triangle's corners, and their data for shading.
#ifndef NACRE_MESH_GLSL
#define NACRE_MESH_GLSL
#include "hit.glsl"
#include "vertex.glsl"

/// As triangleHitThrough() expects it.
vec3 projectVertex(uvec4 vertex, float step) { return projected(toView(vertexPosition(vertex, step))); }

/// A triangle by its vertices.
struct Facet {
    uvec4 a, b, c;
    uvec3 vertices;  // their numbers
    float step;      // step of the vertices' positions
    uint division;   // among the looks of its corners, with kMirrored, for triangleHitThrough()
};

/// Of a triangle in the selected copy. @param packed  word w of the triangle
uint packDivision(uint lookA, uint lookB, uint lookC, uint packed) {
    bool mirrored = dot(cross(copyRow0.xyz, copyRow1.xyz), copyRow2.xyz) < 0.0;
    return uint(lookA == lookB) | uint(lookB == lookC) << 1 | uint(lookC == lookA) << 2 | (packed & 0x1fffffu) << 3 |
           (mirrored ? kMirrored : 0u);
}
/// @param record  of a triangle: places of its vertices a, b, c, which follow `before`
Facet facetFrom(uvec4 a, uvec4 b, uvec4 c, uvec4 record, uint before) {
    return Facet(a, b, c, record.xyz - before, unpackStep(record.w), packDivision(a.w, b.w, c.w, record.w));
}

Hit facetHitThrough(Facet f, vec2 q) {
    return triangleHitThrough(projectVertex(f.a, f.step), projectVertex(f.b, f.step), projectVertex(f.c, f.step), f.division, q);
}

/// Interpolates the vertex normals at a hit, turned towards the viewer. @param packed  vertex normals
void smoothNormal(inout Hit hit, uvec3 packed) {
    precise vec3 n = vertexNormal(packed.x) * hit.shares.x + vertexNormal(packed.y) * hit.shares.y +
                     vertexNormal(packed.z) * hit.shares.z;
    precise vec3 v = vec3(dot(copyRow0.xyz, n), dot(copyRow1.xyz, n), dot(copyRow2.xyz, n));
    precise float square = dot(v, v);
    if (hit.cap || hit.contour || square == 0.0) return;
    precise vec3 unit = v * ((hit.back ? -1.0 : 1.0) * inversesqrt(square));
    hit.normal = unit;
}
#endif
