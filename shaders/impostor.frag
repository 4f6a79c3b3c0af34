#version 440
// Impostor colour and the layers: the same hit, tested against the nearest depth, then written.
//   CYLINDER, TRIANGLE   the primitive; otherwise a sphere
//   INPUT / SAMPLED / FRAGDEPTH   where the nearest depth is: an input attachment, a texture, the depth buffer
//   ORDERED       an attachment that this pass itself keeps, read in raster order
//   MULTISAMPLED  with FRAGDEPTH or ORDERED: four samples of a pixel, covered exactly, in one fragment
//   SETTLE        with INPUT or SAMPLED: encoded depth is coarse, the depth buffer resolves ties
//   SURFACE / IDENTITY            layers instead of colour
//   FETCHED       colour of spheres and triangles: as in common/primitive.glsl
#extension GL_GOOGLE_include_directive : require
#include "common/primitive.glsl"
#include "common/mesh.glsl"
#ifdef MULTISAMPLED
#include "common/multisample.glsl"
vec2 place_;
#define PLACE place_
#endif
#include "common/surface.glsl"
#include "common/encoding.glsl"
#include "common/count.glsl"

// Output of each kind's vertex stage, with colours or with atoms.
#if defined(CYLINDER)
#ifdef IDENTITY
layout(location = 2) flat in uvec2 atoms;
#else
layout(location = 2) flat in vec3 baseA;
layout(location = 3) flat in vec3 baseB;
#endif
layout(location = 5) flat in vec3 axis;
layout(location = 6) flat in vec2 place;
#elif defined(TRIANGLE) && defined(FETCHED)
uint colorAt(Hit hit) {
    if (!kBlendColors) return looks[hit.corner == 0u ? facet.a.w : hit.corner == 1u ? facet.b.w : facet.c.w];
    return cornerColor(uvec3(looks[facet.a.w], looks[facet.b.w], looks[facet.c.w]), hit.corner, hit.shares);
}
#elif defined(TRIANGLE)
layout(location = 5) flat in uvec3 normals;
#ifdef IDENTITY
layout(location = 6) flat in uvec3 atoms;
#else
layout(location = 6) flat in uvec3 colors;
uint colorAt(Hit hit) { return cornerColor(colors, hit.corner, hit.shares); }
#endif
layout(location = 7) flat in uvec3 vertices;
#else
#ifdef IDENTITY
layout(location = 1) flat in uint atom;
#elif !defined(FETCHED)
layout(location = 1) flat in vec3 base;
#endif
#ifndef FETCHED
layout(location = 2) flat in vec2 place;
#endif
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
layout(location = 1) out vec4 nearestOut;
#ifdef MULTISAMPLED
layout(input_attachment_index = 0, set = 0, binding = 3) uniform subpassInputMS nearest;
#else
layout(input_attachment_index = 0, set = 0, binding = 3) uniform subpassInput nearest;
vec4 nearestDepth() { return subpassLoad(nearest); }
#endif
#elif defined(SAMPLED)
layout(set = 0, binding = 3) uniform sampler2D nearestOfView;
vec4 nearestDepth() { return texelFetch(nearestOfView, ivec2(gl_FragCoord.xy), 0); }
#endif

void main() {
    countFragment();
#ifdef MULTISAMPLED
    int covered;
    place_ = placeOfCovered(covered);
    Hit hit = primitiveHitAt(place_);
    float d = encodedDepth(hit.order);
#ifdef ORDERED
    bvec4 behind = greaterThan(vec4(d), vec4(subpassLoad(nearest, 0).x, subpassLoad(nearest, 1).x,
                                             subpassLoad(nearest, 2).x, subpassLoad(nearest, 3).x));
    covered &= ~int(dot(vec4(behind), vec4(1.0, 2.0, 4.0, 8.0)));
#endif
    bool seen = hit.inside && covered != 0;
    gl_SampleMask[0] = covered;
#else
    Hit hit = primitiveHit();
    float d = encodedDepth(hit.order);
    bool seen = hit.inside;
#endif
#if !defined(FRAGDEPTH) && !defined(MULTISAMPLED)
    bool front = isFrontmost(d, nearestDepth());
    seen = seen && front;  // no branch: a single exit
#endif
    if (!seen) discard;
#if defined(FRAGDEPTH) || defined(SETTLE)
    gl_FragDepth = d;
#endif
#ifdef ORDERED
    nearestOut = vec4(d, 0.0, 0.0, 0.0);
#endif
#if defined(TRIANGLE)
#ifdef FETCHED
    uvec3 normals = uvec3(facet.a.z, facet.b.z, facet.c.z), vertices = facet.vertices;
#endif
    smoothNormal(hit, normals);
    Baked baked = meshOcclusion(hit, vertices);
#ifdef IDENTITY
    writeSurface(hit, atoms[hit.corner], baked);
#else
    writeSurface(hit, linearColor(colorAt(hit)), baked);
#endif
#elif defined(CYLINDER)
    bool first = hit.along < 0.5;
    Baked baked = isWire(endA.w) ? kOpen : cylinderOcclusion(hit, axis, place);  // lines have no patch
#ifdef IDENTITY
    writeSurface(hit, first ? atoms.x : atoms.y, baked);
#else
    writeSurface(hit, first ? baseA : baseB, baked);
#endif
#else
#ifdef FETCHED
    vec2 place = placeOfCell(passed.w);
    vec3 base = ball.rgb;
    if (kCopyColors != 0 && ball.w < 0.0) {
        float own = materialIn(base);
        base = (base - vec3(own, 0.0, 0.0)) * copyColor() + vec3(own, 0.0, 0.0);
    }
#endif
    Baked baked = sphereOcclusion(hit, place);
#ifdef IDENTITY
    writeSurface(hit, atom, baked);
#else
    writeSurface(hit, base, baked);
#endif
#endif
}
