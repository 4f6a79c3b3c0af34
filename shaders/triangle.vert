#version 440
// A polygon of three corners around a triangle, flat, at its nearest depth; or as a plate inside it, at its farthest
// depth. Not instanced: three consecutive vertices form a triangle, fetched by its number.
//   READS    as in common/fetch.glsl
//   LOOK     passes data for shading; with ATOM the atoms' numbers in place of the colours
// FETCHED  passes the triangle's number only: the fragment stage fetches the rest
//   NUMBER   passes the primitive's number
// PLATE    the polygon is fully inside the triangle's picture and behind it
#extension GL_GOOGLE_include_directive : require
#include "common/facet.glsl"

#ifdef LOOK
layout(location = 5) flat out uvec3 normals;  // packed, object space
#ifdef ATOM
layout(location = 6) flat out uvec3 atoms;
#else
layout(location = 6) flat out uvec3 colors;
#endif
layout(location = 7) flat out uvec3 vertices;  // numbers of the vertices in their stream
#endif
#ifdef NUMBER
layout(location = 4) flat out uint primitive;
#endif
#if defined(FETCHED)
layout(location = 0) flat out uint number;
#elif !defined(PLATE)
layout(location = 0) flat out vec3 cornerA;
layout(location = 1) flat out vec3 cornerB;
layout(location = 2) flat out vec3 cornerC;
layout(location = 3) flat out uint division;
#endif
invariant gl_Position;

float farZ(vec3 a, vec3 b, vec3 c) {
    return kPerspective ? 1.0 / min(a.z, min(b.z, c.z)) : max(a.z, max(b.z, c.z));
}
float nearZ(vec3 a, vec3 b, vec3 c) {
    return kPerspective ? 1.0 / max(a.z, max(b.z, c.z)) : min(a.z, min(b.z, c.z));
}

void main() {
    // Division by three for numbers below 2^26, with a third of the instructions of drivers: 4096 is 3 * 1365 + 1.
    uint high = uint(gl_VertexIndex) >> 12, sum = high + (uint(gl_VertexIndex) & 4095u), third = sum * 21846u >> 16;
    uint triangle = 1365u * high + third;
    int corner = int(sum - 3u * third);
    Facet f = loadFacet(triangle);
    vec3 a = projectVertex(f.a, f.step), b = projectVertex(f.b, f.step), c = projectVertex(f.c, f.step);
#if defined(FETCHED)
    number = triangle;
#elif !defined(PLATE)
    cornerA = a;
    cornerB = b;
    cornerC = c;
    division = f.division;
#endif
#ifdef LOOK
    normals = uvec3(f.a.z, f.b.z, f.c.z);
#ifdef ATOM
    atoms = uvec3(looks[f.a.w + 1u], looks[f.b.w + 1u], looks[f.c.w + 1u]);
#else
    colors = uvec3(looks[f.a.w], looks[f.b.w], looks[f.c.w]);
#endif
    vertices = f.vertices;
#endif
#ifdef NUMBER
    // Numbers follow the copy's spheres and cylinders.
    primitive = view.numberBefore + view.spheres + view.cylinders + triangle + 1u;
#endif
    // Moves all edges outwards by at least a margin: scales the triangle about its incentre, the mean of the corners
    // weighted by the lengths of the opposite edges. |x| + |y| replaces the length, which is never shorter, so no root
    // is needed. From corner a on, where the path of a corner is 0, ab or -ca: offset = (path * perimeter - mean) *
    // margin / area, with mean = longB * ab - longC * ca.
    vec2 ab = b.xy - a.xy, ca = a.xy - c.xy, bc = c.xy - b.xy;
    float longA = abs(bc.x) + abs(bc.y), longB = abs(ca.x) + abs(ca.y), longC = abs(ab.x) + abs(ab.y);
    float around = longA + longB + longC;
    float turned = edgeSide(ab, ca), area = abs(turned);  // twice the area
    bool away = kFrontsOnly && turned > 0.0 && area > 1e-3 * around * around;
    // Margin: the rasteriser's snap, and rounding of the values above (about 1e-6 of the picture).
    float margin = 1.5 * snapReach() + 4e-6 * (abs(a.x) + abs(a.y) + around);
#ifdef PLATE
    margin = -margin;
#else
    margin += view.contourWidth * float(kContours);
#endif
    vec2 way = corner == 0 ? vec2(0.0) : corner == 1 ? ab : -ca;
    vec2 q = a.xy + way + (way * around - (longB * ab - longC * ca)) * (margin / max(area, 1e-30));
#ifdef PLATE
    float Z = farZ(a, b, c), front = nearZ(a, b, c);
    bool drawn = !away && area > -2.0 * margin * around && area > 1e-3 * around * around;
    if (kClip && (front < view.clipNear || Z > view.clipFar)) drawn = false;
    if (!drawn) q = a.xy;
    gl_Position = clipPosition(q, encodedDepth(Z + 1e-4 * (Z - view.depthStart)) + 1e-6);
#else
    if (area < 5e-3 * around * around) {
        // A sliver: its moved corners would be far away. Half of a box of twice the size contains it.
        vec2 low = min(a.xy, min(b.xy, c.xy)) - margin, size = max(a.xy, max(b.xy, c.xy)) + margin - low;
        q = low + 2.001 * size * vec2(corner == 1, corner == 2);
    }
    vec3 middle = vertexPosition(f.a, f.step) + vertexPosition(f.b, f.step) + vertexPosition(f.c, f.step);
    if (away || isCutOff(toView(middle / 3.0))) q = a.xy;
    float room = 1e-4 * (1.0 + abs(view.origin));
    gl_Position = clipPosition(q, encodedDepth(nearZ(a, b, c) - room));
#endif
}
