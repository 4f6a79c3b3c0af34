#version 440
// The geometry pass of the `deferred` path: the nearest primitive, its depth through the depth buffer. Also finds
// layers of translucent primitives.
//   PEEL   the nearest behind the previous layer (C. Everitt 2001, "Interactive Order-Independent Transparency")
#extension GL_GOOGLE_include_directive : require
#include "common/primitive.glsl"
#include "common/count.glsl"

layout(depth_greater) out float gl_FragDepth;
layout(location = 4) flat in uint primitive;  // 1-based: of each copy spheres, then cylinders, then triangles
layout(location = 0) out uvec2 nearestPrimitive;  // y: for targets of two channels, the bits of its Z
layout(constant_id = kDistancesId) const bool kDistances = false;
#ifdef PEEL
#include "common/layers.glsl"
layout(set = 0, binding = 3) uniform sampler2D layerBefore;  // depth of the previous layer; 1: none
#endif

void main() {
    countFragment();
    Hit hit = primitiveHit();
    if (!hit.inside) discard;
    float d = encodedDepth(hit.order);
#ifdef PEEL
    if (!(d > texelFetch(layerBefore, ivec2(gl_FragCoord.xy), 0).x + kLayerStep)) discard;
#endif
    gl_FragDepth = d;
    nearestPrimitive = uvec2(primitive, kDistances ? floatBitsToUint(hit.Z) : 0u);
}
