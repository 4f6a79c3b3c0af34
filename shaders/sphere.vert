#version 440
// The impostor polygon of a sphere: flat, at the sphere's nearest depth, around its silhouette.
//   LOOK     passes data for shading; with ATOM the atom's number in place of the colour
// FETCHED  with LOOK: passes the centre and the patch position, from which the fragment stage fetches the rest
//   NUMBER   passes the primitive's number
#extension GL_GOOGLE_include_directive : require
#include "common/atlas.glsl"
#if defined(LOOK) && !defined(FETCHED)
#include "common/copy_color.glsl"
#endif
#include "common/outline.glsl"

layout(location = 0) in vec4 inSphere;
layout(location = 4) in vec4 inRowA;  // of an ellipsoid
layout(location = 5) in vec4 inRowB;
layout(location = 3) in vec3 inCorner;  // engine/passes/corners.h
#if defined(FETCHED)
layout(location = 0) flat out uvec4 passed;
#else
layout(location = 0) flat out vec4 sphere;
#ifdef LOOK
layout(location = 1) in uvec2 inLook;
#ifdef ATOM
layout(location = 1) flat out uint atom;
#else
layout(location = 1) flat out vec3 base;  // linear colour, converted per primitive
#endif
layout(location = 2) flat out vec2 place;  // of its patch
#endif
#endif
#ifdef NUMBER
layout(location = 4) flat out uint primitive;
#endif
layout(location = 5) flat out vec4 rowA;
layout(location = 6) flat out vec4 rowB;
invariant gl_Position;

void main() {
    precise vec3 center = toView(inSphere.xyz);
    float radius = inSphere.w;
    if (kEllipsoids != 0) {
        rowA = rowToView(inRowA);
        rowB = rowToView(inRowB);
    }
#ifdef FETCHED
    passed = uvec4(floatBitsToUint(center), sphereCell(uint(gl_InstanceIndex)));
#else
    sphere = vec4(center, radius);
#ifdef LOOK
#ifdef ATOM
    atom = inLook.y;
#else
    base = linearColor(inLook.x);
#endif
    place = patchPlace(spherePatch(uint(gl_InstanceIndex)));
#endif
#endif
#ifdef NUMBER
    primitive = view.numberBefore + uint(gl_InstanceIndex) + 1u;
#endif
    Outline outline = sphereOutline(center, outlinedRadius(center.z, radius));
    vec2 q = outline.center + outline.axisU * inCorner.x + outline.axisV * inCorner.y;
    // With inclined facets, a corner moved by the rasteriser would change depth.
    float front = radius * inCorner.z + (kCorners == 9 ? 2.0 * snapReach() : 0.0) + kCapRoom;
    if (isCutOff(center)) q = outline.center;
    float depth = encodedDepth(view.origin - center.z - front);
    // An apex before the near end of the depth range would be clamped, and its facets would sink into the sphere.
    float apex = view.origin - center.z - (1.252 * radius + 2.0 * snapReach() + kCapRoom);
    if (kCorners == 9 && encodedDepth(apex) < 0.0) depth = 0.0;
    gl_Position = clipPosition(q, depth);
}
