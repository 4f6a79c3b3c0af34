#version 450
// The `deferred` path's one geometry pass: which primitive is nearest, its depth through the depth buffer.
//   DISTANCE   how far away it is, too
#extension GL_GOOGLE_include_directive : require
#include "common/primitive.glsl"
#include "common/count.glsl"

layout(depth_greater) out float gl_FragDepth;
layout(location = 4) flat in uint primitive;  // 1-based: of each copy spheres, then cylinders, then triangles
#ifdef DISTANCE
layout(location = 0) out uvec2 nearestPrimitive;  // and the bits of its Z
#else
layout(location = 0) out uint nearestPrimitive;
#endif

void main() {
    countFragment();
    Hit hit = primitiveHit();
    if (!hit.inside) discard;
    gl_FragDepth = encodedDepth(hit.order);
#ifdef DISTANCE
    nearestPrimitive = uvec2(primitive, floatBitsToUint(hit.Z));
#else
    nearestPrimitive = primitive;
#endif
}
