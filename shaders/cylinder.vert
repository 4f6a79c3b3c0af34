#version 440
// The impostor polygon of a cylinder: a rectangle along its axis, flat, at the cylinder's nearest depth.
//   LOOK, ATOM, NUMBER   as in sphere.vert
#extension GL_GOOGLE_include_directive : require
#include "common/atlas.glsl"
#ifdef LOOK
#include "common/copy_color.glsl"
#endif
#include "common/outline.glsl"

layout(location = 0) in vec4 inA;  // xyz, radius
layout(location = 1) in vec4 inB;  // xyz, 1 / length
#ifdef LOOK
layout(location = 2) in uvec4 inLook;
#ifdef ATOM
layout(location = 2) flat out uvec2 atoms;
#else
layout(location = 2) flat out vec3 baseA;  // linear colours
layout(location = 3) flat out vec3 baseB;
#endif
layout(location = 5) flat out vec3 axis;  // object space
layout(location = 6) flat out vec2 place;  // of its patch
#endif
layout(location = 0) flat out vec4 endA;  // view space, radius
layout(location = 1) flat out vec4 endB;
#ifdef NUMBER
layout(location = 4) flat out uint primitive;
#endif
invariant gl_Position;

/// Extent of an ellipse in a direction.
float reach(Outline o, vec2 direction) {
    return dot(o.center, direction) + length(vec2(dot(o.axisU, direction), dot(o.axisV, direction)));
}

void main() {
    precise vec3 a = toView(inA.xyz);
    precise vec3 b = toView(inB.xyz);
    float radius = stickRadius(inA.w, a.z, b.z);
    endA = vec4(a, radius);
    radius = abs(radius);
    endB = vec4(b, inB.w);
#ifdef LOOK
#ifdef ATOM
    atoms = inLook.zw;
#else
    baseA = linearColor(inLook.x);
    baseB = linearColor(inLook.y);
#endif
    axis = (inB.xyz - inA.xyz) * inB.w;
    place = patchPlace(cylinderPatch(uint(gl_InstanceIndex)));
#endif
#ifdef NUMBER
    // Numbers follow the copy's spheres.
    primitive = view.numberBefore + view.spheres + uint(gl_InstanceIndex) + 1u;
#endif
    vec3 ahead = normalize(b - a);
    // The hull of the silhouettes of both ends, as spheres of the cylinder's radius, contains the cylinder in any
    // projection.
    Outline oa = sphereOutline(a, outlinedRadius(a.z, radius));
    Outline ob = sphereOutline(b, outlinedRadius(b.z, radius));
    vec2 along = ob.center - oa.center;
    float span = length(along);
    vec2 u = span > 1e-6 ? along / span : vec2(1.0, 0.0);
    vec2 v = vec2(-u.y, u.x);
    float low = -reach(oa, -u);
    float high = reach(ob, u);
    low = min(low, -reach(ob, -u));
    high = max(high, reach(oa, u));
    if (!kPerspective) {
        // A flat cap extends by r |axis.z| only.
        float cap = radius * abs(ahead.z) + snapReach();
        low = dot(oa.center, u) - cap;
        high = dot(ob.center, u) + cap;
    }
    float left = min(-reach(oa, -v), -reach(ob, -v));
    float right = max(reach(oa, v), reach(ob, v));
    bool first = (gl_VertexIndex & 1) == 0;
    bool second = (gl_VertexIndex & 2) == 0;
    vec2 q = u * (first ? low : high) + v * (second ? left : right);
    if (isCutOff(0.5 * (a + b))) q = oa.center;
    float front = max(a.z, b.z) + radius * sqrt(max(1.0 - ahead.z * ahead.z, 0.0));
    gl_Position = clipPosition(q, encodedDepth(view.origin - front - radius * 1e-3 - kCapRoom));
}
