#version 450
// The `deferred` path's one geometry pass: which primitive is nearest, its depth through the depth buffer.
#extension GL_GOOGLE_include_directive : require
#include "common/hit.glsl"
#include "common/count.glsl"

layout(depth_greater) out float gl_FragDepth;
#ifdef CYLINDER
layout(location = 0) flat in vec4 endA;
layout(location = 1) flat in vec4 endB;
#else
layout(location = 0) flat in vec4 sphere;
#endif
layout(location = 4) flat in uint primitive;  // 1-based: of each copy spheres, then cylinders
layout(location = 0) out uint nearestPrimitive;

void main() {
    countFragment();
#ifdef CYLINDER
    Hit hit = cylinderHit(endA.xyz, endB.xyz, endA.w, gl_FragCoord.xy);
#else
    Hit hit = sphereHit(sphere, gl_FragCoord.xy);
#endif
    if (!hit.inside) discard;
    gl_FragDepth = encodedDepth(hit.order);
    nearestPrimitive = primitive;
}
