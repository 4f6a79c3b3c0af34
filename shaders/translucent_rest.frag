#version 440
// Adds up translucent primitives behind the layers in order (common/rest.glsl). The depth test drops what opaque shapes
// hide.
//   CYLINDER, TRIANGLE   as in common/primitive.glsl
#extension GL_GOOGLE_include_directive : require
#define TRANSLUCENT
#include "common/primitive.glsl"
#include "common/mesh.glsl"
#include "common/color.glsl"
#include "common/count.glsl"
#include "common/layers.glsl"
#include "common/rest.glsl"

layout(depth_greater) out float gl_FragDepth;
layout(location = 4) flat in uint primitive;  // as in identify.frag
layout(location = 0) out vec4 sum;
layout(location = 1) out vec4 depthSum;  // x
layout(set = 0, binding = 3) uniform sampler2D lastLayer;  // depth of the last layer in order; 1: none
layout(set = 0, binding = 4, std430) readonly buffer Shapes { uvec4 shapes[]; };
layout(set = 0, binding = 5, std430) readonly buffer Looks { uint looks[]; };

void main() {
    countFragment();
    Hit hit = primitiveHit();
    float d = encodedDepth(hit.order), before = texelFetch(lastLayer, ivec2(gl_FragCoord.xy), 0).x;
    bool seen = hit.inside && d > before + kLayerStep;
#ifdef TRIANGLE
    if (seen && min(hit.shares.x, min(hit.shares.y, hit.shares.z)) == 0.0)
        seen = ownsEdge(cornerA, cornerB, cornerC, planePoint(gl_FragCoord.xy));
#endif
    if (!seen) discard;
    gl_FragDepth = d;
    uint index = primitive - 1u - view.numberBefore;
#if defined(TRIANGLE)
    uvec4 record = shapes[index + view.cylinders];  // behind two records per cylinder
    uvec4 v0 = shapes[record.x], v1 = shapes[record.y], v2 = shapes[record.z];
    smoothNormal(hit, uvec3(v0.z, v1.z, v2.z));
    Baked baked = meshOcclusion(hit, record.xyz - (view.primitives + view.cylinders));
    uint bits = cornerColor(uvec3(looks[v0.w], looks[v1.w], looks[v2.w]), hit.corner, hit.shares);
#elif defined(CYLINDER)
    index -= view.spheres;
    vec4 shapeA = uintBitsToFloat(shapes[view.spheres + 2u * index]);
    vec4 shapeB = uintBitsToFloat(shapes[view.spheres + 2u * index + 1u]);
    Baked baked = kOpen;
    if (!isWire(endA.w) && shadesOcclusion(hit))
        baked = cylinderTexel(index, cylinderCoordinate(hit, (shapeB.xyz - shapeA.xyz) * shapeB.w));
    uint bits = looks[2u * view.spheres + 4u * index + (hit.along < 0.5 ? 0u : 1u)];
#else
    Baked baked = kOpen;
    if (shadesOcclusion(hit)) baked = sphereTexel(index, sphereCoordinate(hit));
    uint bits = looks[2u * index];
#endif
    vec3 lit = computeLight(hit, bits, baked, planePoint(gl_FragCoord.xy));
    precise float behind = d - before;
    RestPart part = restPart(lit, unpackOpacity(bits), behind);
    sum = part.color;
    depthSum = vec4(part.depth, 0.0, 0.0, 0.0);
}
