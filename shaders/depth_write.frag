#version 450
// The nearest depth alone, through the depth buffer: what `fragdepth` occlusion maps are made of.
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

void main() {
    countFragment();
#ifdef CYLINDER
    Hit hit = cylinderHit(endA.xyz, endB.xyz, endA.w, gl_FragCoord.xy);
#else
    Hit hit = sphereHit(sphere, gl_FragCoord.xy);
#endif
    if (!hit.inside) discard;
    gl_FragDepth = encodedDepth(hit.order);
}
