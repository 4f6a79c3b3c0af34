#version 440
// The nearest depth only, through the depth buffer: for `fragdepth` occlusion maps.
#extension GL_GOOGLE_include_directive : require
#include "common/primitive.glsl"
#include "common/count.glsl"

layout(depth_greater) out float gl_FragDepth;

void main() {
    countFragment();
    Hit hit = primitiveHit();
    if (!hit.inside) discard;
    gl_FragDepth = encodedDepth(hit.order);
}
