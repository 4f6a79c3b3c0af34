#version 450
// Impostor colour and the layers: the same hit, tested against the nearest depth, then written out.
//   CYLINDER, TRIANGLE   the primitive; otherwise a sphere
//   INPUT / SAMPLED / FRAGDEPTH   where the nearest depth is: an input attachment, a texture, the depth buffer
//   ORDERED       an attachment that this pass itself keeps, read in raster order
//   SETTLE        with INPUT or SAMPLED: encoded depth is coarse, the depth buffer settles what it leaves open
//   SURFACE / IDENTITY            layers instead of colour
#extension GL_GOOGLE_include_directive : require
#include "common/primitive.glsl"
#include "common/mesh.glsl"
#include "common/surface.glsl"
#include "common/encoding.glsl"
#include "common/count.glsl"

#if defined(CYLINDER)
layout(location = 2) flat in uvec4 look;  // colour a, colour b, atom a, atom b
layout(location = 3) flat in vec4 axisPatch;
#elif defined(TRIANGLE)
layout(location = 5) flat in uvec3 normals;  // all as triangle.vert has them
layout(location = 6) flat in uvec3 colors;
layout(location = 7) flat in uvec3 atoms;
layout(location = 8) flat in uvec3 vertices;
#else
layout(location = 1) flat in uvec3 look;  // colour, atom, patch
#endif

#if defined(FRAGDEPTH) || defined(SETTLE)
layout(depth_greater) out float gl_FragDepth;
#else
layout(early_fragment_tests) in;
#endif
#if defined(INPUT)
layout(input_attachment_index = 0, set = 0, binding = 3) uniform subpassInput nearest;
vec4 nearestDepth() { return subpassLoad(nearest); }
#elif defined(ORDERED)
layout(input_attachment_index = 0, set = 0, binding = 3) uniform subpassInput nearest;
layout(location = 1) out vec4 nearestOut;
vec4 nearestDepth() { return subpassLoad(nearest); }
#elif defined(SAMPLED)
layout(set = 0, binding = 3) uniform sampler2D nearest;
vec4 nearestDepth() { return texelFetch(nearest, ivec2(gl_FragCoord.xy), 0); }
#endif

void main() {
    countFragment();
    Hit hit = primitiveHit();
    if (!hit.inside) discard;
    float d = encodedDepth(hit.order);
#if defined(FRAGDEPTH) || defined(SETTLE)
    gl_FragDepth = d;
#endif
#ifndef FRAGDEPTH
    if (!isFrontmost(d, nearestDepth())) discard;
#endif
#ifdef ORDERED
    nearestOut = vec4(d, 0.0, 0.0, 0.0);
#endif
#if defined(TRIANGLE)
    smoothNormal(hit, normals);
    float occlusion = meshOcclusion(hit, vertices);
    writeSurface(hit, colors[hit.corner], atoms[hit.corner], occlusion);
#elif defined(CYLINDER)
    bool first = hit.along < 0.5;
    float occlusion = cylinderOcclusion(hit, axisPatch.xyz, floatBitsToUint(axisPatch.w));
    writeSurface(hit, first ? look.x : look.y, first ? look.z : look.w, occlusion);
#else
    writeSurface(hit, look.x, look.y, sphereOcclusion(hit, look.z));
#endif
}
