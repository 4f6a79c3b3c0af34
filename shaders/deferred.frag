#version 450
// The `deferred` path's shading: each covered pixel once. The hit is rebuilt from the pixel and the record of the
// primitive that owns it, by the same arithmetic that the geometry pass used.
//   INPUT / SAMPLED      where the primitive's number is
//   SURFACE / IDENTITY   layers instead of colour
//   RIMS                 lines and halos are known, and laid over
//   TRANSLUCENT          on every path: a layer of translucent triangles over what is opaque, where that is not in front
//     TESTED, NEAREST_INPUT, NEAREST_SAMPLED   by the depth test, or by the nearest depth: an input attachment, a texture
#extension GL_GOOGLE_include_directive : require
#define COPY_OF_PIXEL
#include "common/surface.glsl"
#include "common/mesh.glsl"
#include "common/count.glsl"
#ifdef TRANSLUCENT
#include "common/encoding.glsl"
#endif

#ifdef INPUT
layout(input_attachment_index = 0, set = 0, binding = 3) uniform usubpassInput primitives;
uint primitiveHere() { return subpassLoad(primitives).x; }
#else
layout(set = 0, binding = 3) uniform usampler2D primitives;
uint primitiveHere() { return texelFetch(primitives, ivec2(gl_FragCoord.xy), 0).x; }
#endif
layout(set = 0, binding = 4, std430) readonly buffer Shapes { uvec4 shapes[]; };
vec4 shapeAt(uint i) { return uintBitsToFloat(shapes[i]); }
layout(set = 0, binding = 5, std430) readonly buffer Looks { uint looks[]; };  // two a sphere, four a cylinder, two for vertices that look the same
layout(set = 0, binding = 6, std430) readonly buffer CopyRows { vec4 copyRows[]; };  // three a copy
#if defined(NEAREST_INPUT)
layout(input_attachment_index = 0, set = 0, binding = 7) uniform subpassInput nearest;
bool isHidden(float d) { return !isFrontmost(d, subpassLoad(nearest)); }
#elif defined(NEAREST_SAMPLED)
layout(set = 0, binding = 7) uniform sampler2D nearest;
bool isHidden(float d) { return !isFrontmost(d, texelFetch(nearest, ivec2(gl_FragCoord.xy), 0)); }
#endif

/// @param index  of the triangle
void shadeTriangle(uint index) {
    uvec4 record = shapes[view.spheres + 2u * view.cylinders + index];
    // Not an array that is indexed: drivers keep such in memory, and one ends the program over it (docs/tilers.md).
    uvec4 v0 = shapes[record.x], v1 = shapes[record.y], v2 = shapes[record.z];
    float step = uintBitsToFloat(record.w);
    Hit hit = triangleHitThrough(cornerOf(v0, step), cornerOf(v1, step), cornerOf(v2, step),
                                 joinsOf(v0.w, v1.w, v2.w), planePoint(gl_FragCoord.xy));
#ifdef TRANSLUCENT
    float d = encodedDepth(hit.order);
#ifdef TESTED
    gl_FragDepth = d;
#else
    if (isHidden(d)) discard;
#endif
#endif
    smoothNormal(hit, uvec3(v0.z, v1.z, v2.z));
    uint look = hit.corner == 0u ? v0.w : hit.corner == 1u ? v1.w : v2.w;
    writeSurface(hit, looks[look], looks[look + 1u],
                 meshOcclusion(hit, record.xyz - (view.primitives + view.cylinders)));
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
    uint primitives = view.primitives;
    uint copy = (number - 1u) / primitives;
    uint index = (number - 1u) % primitives;
    copyIndex = copy;
    copyRow0 = copyRows[3u * copy];
    copyRow1 = copyRows[3u * copy + 1u];
    copyRow2 = copyRows[3u * copy + 2u];
    uint spheres = view.spheres;
#ifdef TRANSLUCENT
    shadeTriangle(index - spheres - view.cylinders);
#else
    if (index < spheres) {
        vec4 shape = shapeAt(index);
        precise vec3 center = toView(shape.xyz);
        Hit hit = sphereHit(vec4(center, shape.w), gl_FragCoord.xy);
        writeSurface(hit, looks[2u * index], looks[2u * index + 1u], sphereOcclusion(hit, spherePatch(index)));
        return;
    }
    index -= spheres;
    if (index >= view.cylinders) {
        shadeTriangle(index - view.cylinders);
        return;
    }
    vec4 shapeA = shapeAt(spheres + 2u * index);
    vec3 shapeB = shapeAt(spheres + 2u * index + 1u).xyz;
    precise vec3 a = toView(shapeA.xyz);
    precise vec3 b = toView(shapeB);
    Hit hit = cylinderHit(a, b, shapeA.w, gl_FragCoord.xy);
    uint look = 2u * spheres + 4u * index + (hit.along < 0.5 ? 0u : 1u);
    float occlusion = cylinderOcclusion(hit, normalize(shapeB - shapeA.xyz), cylinderPatch(index));
    writeSurface(hit, looks[look], looks[look + 2u], occlusion);
#endif
}
