#version 450
// The impostor polygon of a sphere: flat, at the sphere's nearest depth, around its silhouette.
#extension GL_GOOGLE_include_directive : require
#include "common/atlas.glsl"
#include "common/outline.glsl"

layout(location = 0) in vec4 inSphere;
#ifdef LOOK
layout(location = 1) in uvec2 inLook;
layout(location = 1) flat out uvec3 look;  // colour, atom, patch
#endif
layout(location = 0) flat out vec4 sphere;
#ifdef NUMBER
layout(location = 4) flat out uint primitive;
#endif
invariant gl_Position;

void main() {
    precise vec3 center = toView(inSphere.xyz);
    float radius = inSphere.w;
    sphere = vec4(center, radius);
#ifdef LOOK
    look = uvec3(inLook, spherePatch(uint(gl_InstanceIndex)));
#endif
#ifdef NUMBER
    primitive = view.numberBefore + uint(gl_InstanceIndex) + 1u;
#endif
    Outline outline = sphereOutline(center, reachOf(center.z, radius));
    bool apex;
    vec2 e = kCorners == 9 ? pyramidCorner(gl_VertexIndex, apex) : corner(gl_VertexIndex);
    vec2 q = outline.center + outline.axisU * e.x + outline.axisV * e.y;
    // A little nearer than the nearest point, so that rounding never lets the fixed-function test cut into it.
    float front = radius * 1.001;
    if (kCorners == 9) front = radius * (pyramidHeight(apex) + 2e-3) + 2.0 * view.snap;
    if (isCutOff(center)) q = outline.center;
    gl_Position = clipPosition(q, encodedDepth(view.origin - center.z - front));
}
