#version 440
// Shading of the `deferred` path: each covered pixel once. Recomputes the hit from the pixel and its primitive's
// record, by the same arithmetic as the geometry pass.
//   INPUT / SAMPLED      source of the primitive's number
//   SURFACE / IDENTITY   layers instead of colour
//   DEPTH                writes the hit's depth to the depth buffer, for later draws
//   RIMS                 composites outlines and halos
//   TRANSLUCENT          on every path: composites a layer of translucent primitives where the depth test passes
#extension GL_GOOGLE_include_directive : require
#define COPY_OF_PIXEL
#include "common/surface.glsl"
#include "common/mesh.glsl"
#include "common/count.glsl"

#ifdef INPUT
layout(input_attachment_index = 0, set = 0, binding = 3) uniform usubpassInput primitives;
uint primitiveHere() { return subpassLoad(primitives).x; }
#else
layout(set = 0, binding = 3) uniform usampler2D primitivesOfView;
uint primitiveHere() { return texelFetch(primitivesOfView, ivec2(gl_FragCoord.xy), 0).x; }
#endif
layout(set = 0, binding = 4, std430) readonly buffer Shapes { uvec4 shapes[]; };
vec4 shapeAt(uint i) { return uintBitsToFloat(shapes[i]); }
uint countShapes() { return uint(shapes.length()); }
#include "common/balls.glsl"
layout(set = 0, binding = 5, std430) readonly buffer Looks { uint looks[]; };  // 2 per sphere or vertex, 4 per cylinder
layout(set = 0, binding = 6, std430) readonly buffer CopyRows { vec4 copyRows[]; };  // three per copy
// Primitives of the scene; absent kinds cost nothing.
layout(constant_id = kCopiesId) const bool kCopies = true;
layout(constant_id = kCylindersId) const bool kCylinders = true;
layout(constant_id = kTrianglesId) const bool kTriangles = true;

/// Visible data of a pixel's primitive of any kind; shading follows once for all kinds.
struct Shown {
    Hit hit;
    uint look;  // index of the primitive's colour in the looks, which its atom's number follows
    uvec3 corners;  // triangles: the same for each corner
    Baked baked;  // triangles; others read a texel of a patch:
    uint patchAddress;
    vec2 at, texels;  // position in the patch, 0..1, and the patch's size
    bool wire;        // a wire, which has no occlusion
};

/// Selects the copy of a number. @returns the primitive in it
uint placed(uint number) {
    uvec2 at = kCopies ? divided(number - 1u, view.primitives) : uvec2(0u, number - 1u);
    copyIndex = at.x;
    // Rows of the second view follow those of the first.
    copyRow0 = copyRows[3u * at.x + (viewIndex() == 0 ? 0u : view.numberBefore)];
    copyRow1 = copyRows[3u * at.x + 1u];
    copyRow2 = copyRows[3u * at.x + 2u];
    return at.y;
}

/// @param index  of the triangle
void showTriangle(uint index, inout Shown shown) {
    uvec4 record = shapes[view.spheres + 2u * view.cylinders + index];
    // Not an indexed array: drivers keep those in memory, and one crashes on them (docs/tilers.md).
    uvec4 v0 = shapes[record.x], v1 = shapes[record.y], v2 = shapes[record.z];
    Facet f = facetFrom(v0, v1, v2, record, view.primitives + view.cylinders);
    Hit hit = facetHitThrough(f, planePoint(gl_FragCoord.xy));
    smoothNormal(hit, uvec3(v0.z, v1.z, v2.z));
    shown.look = hit.corner == 0u ? v0.w : hit.corner == 1u ? v1.w : v2.w;
    shown.corners = uvec3(v0.w, v1.w, v2.w);
    shown.baked = meshOcclusion(hit, f.vertices);
    shown.hit = hit;
}

void showCylinder(uint index, inout Shown shown) {
    vec4 shapeA = shapeAt(view.spheres + 2u * index);
    vec4 shapeB = shapeAt(view.spheres + 2u * index + 1u);
    precise vec3 a = toView(shapeA.xyz);
    precise vec4 b = endToView(shapeB);
    shown.hit = cylinderHit(a, b, stickRadius(shapeA.w, a.z, b.z), gl_FragCoord.xy);
    shown.wire = isWire(shapeA.w);
    shown.look = 2u * view.spheres + 4u * index + (shown.hit.along < 0.5 ? 0u : 1u);
    shown.at = cylinderCoordinate(shown.hit, (shapeB.xyz - shapeA.xyz) * shapeB.w);
    shown.texels = vec2(cylinderTexels());
    shown.patchAddress = cylinderPatch(index);
}

void showSphere(uint index, inout Shown shown) {
    vec4 shape = shapeAt(index);
    precise vec3 center = toView(shape.xyz);
    shown.hit = ballHitThrough(index, vec4(center, shape.w), planePoint(gl_FragCoord.xy));
    shown.look = 2u * index;
    shown.at = sphereCoordinate(shown.hit);
    shown.texels = vec2(sphereEdge());
    shown.patchAddress = spherePatch(index);
}

void main() {
    uint number = primitiveHere();
#ifdef RIMS
    if (number == 0u) {
        writeRimmed(vec4(0.0));
        return;
    }
#else
    if (number == 0u) discard;
#endif
    countFragment();
    uint index = placed(number);
    Shown shown = Shown(noHit(), 0u, uvec3(0u), kOpen, 0u, vec2(0.0), vec2(2.0), false);
    uint firstTriangle = view.spheres + view.cylinders;
    bool cylinder = kCylinders && index >= view.spheres && index < firstTriangle;
    bool triangle = kTriangles && index >= firstTriangle;
    if (triangle)
        showTriangle(index - firstTriangle, shown);
    else if (cylinder)
        showCylinder(index - view.spheres, shown);
    else
        showSphere(index, shown);
#if defined(DEPTH) || defined(TRANSLUCENT)
    gl_FragDepth = encodedDepth(shown.hit.order);
#endif
    if (!triangle && !shown.wire && shadesOcclusion(shown.hit))
        shown.baked = patchTexel(patchPlace(shown.patchAddress), shown.at, shown.texels);
    uint colorBits = looks[shown.look];
    if (kBlendColors && triangle)
        colorBits = cornerColor(uvec3(looks[shown.corners.x], looks[shown.corners.y], looks[shown.corners.z]),
                                shown.hit.corner, shown.hit.shares);
    // Atoms follow the colours, two for a cylinder.
    writeSurface(shown.hit, colorBits, looks[shown.look + (cylinder ? 2u : 1u)], shown.baked);
}
