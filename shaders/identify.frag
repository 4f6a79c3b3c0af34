#version 450
// The `deferred` path's one geometry pass: which primitive is nearest, its depth through the depth buffer.
#extension GL_GOOGLE_include_directive : require
#include "common/primitive.glsl"
#include "common/count.glsl"

layout(depth_greater) out float gl_FragDepth;
layout(location = 4) flat in uint primitive;  // 1-based: of each copy spheres, then cylinders, then triangles
layout(location = 0) out uint nearestPrimitive;

void main() {
    countFragment();
    Hit hit = primitiveHit();
    if (!hit.inside) discard;
    gl_FragDepth = encodedDepth(hit.order);
    nearestPrimitive = primitive;
}
