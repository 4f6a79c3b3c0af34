#version 440
// Outlines and halos. The rim of a primitive depends on the surface behind it, which is known by now. A MAX blend keeps
// the densest of several rims in a pixel.
//   CYLINDER, TRIANGLE   as in common/primitive.glsl
//   INPUT / SAMPLED      where numbers and distances are
#extension GL_GOOGLE_include_directive : require
#include "common/primitive.glsl"
#include "common/count.glsl"

layout(early_fragment_tests) in;
layout(location = 4) flat in uint primitive;  // as in identify.frag
layout(location = 0) out vec4 rim;  // freedom of the outline from fog, whether there is an outline, density of the halo
#ifdef INPUT
layout(input_attachment_index = 0, set = 0, binding = 3) uniform usubpassInput nearestPrimitive;
uvec2 nearestHere() { return subpassLoad(nearestPrimitive).xy; }
#else
layout(set = 0, binding = 3) uniform usampler2D nearestPrimitive;
uvec2 nearestHere() { return texelFetch(nearestPrimitive, ivec2(gl_FragCoord.xy), 0).xy; }
#endif
layout(set = 0, binding = 4, std430) readonly buffer Shapes { uvec4 shapes[]; };
uvec4 shapeBits(uint i) { return shapes[i]; }
layout(set = 0, binding = 5, std430) readonly buffer Looks { uint looks[]; };
uint lookAt(uint i) { return looks[i]; }
#include "common/rims.glsl"

void main() {
    countFragment();
    Hit hit = primitiveHit();
    if (!hit.contour) discard;
    uvec2 nearest = nearestHere();
    bool behind = nearest.x != 0u;
    uvec2 there = divided(max(nearest.x, 1u) - 1u, view.primitives), here = divided(primitive - 1u, view.primitives);
    rim = vec4(shadeRim(hit, Owner(here.x, lookGroup(here.y, hit.along >= 0.5)), behind,
                     Owner(there.x, lookGroup(there.y, false)), behind ? uintBitsToFloat(nearest.y) : 1e30),
               0.0);
}
