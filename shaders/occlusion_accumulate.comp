#version 450
// Ambient occlusion, one batch of directions: every texel of the list asks each depth map of the batch whether it is
// the front-most at its place, and adds up the cosine of those that say yes. One read and one write of its sum.
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"
#include "common/patch.glsl"
#include "common/texel.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 4) uniform sampler2D depthMaps;  // a grid of maps
layout(set = 0, binding = 1, std430) readonly buffer Directions { vec4 rows[]; };  // three rotation rows a direction
layout(set = 0, binding = 2, std430) readonly buffer Texels { uint texels[]; };
layout(set = 0, binding = 3, std430) buffer Sums { float sums[]; };

/// Depth at which the texel's own surface meets a pixel centre: what its primitive wrote there, if it was in front.
float ownZ(Texel texel, vec3 u, vec3 v, vec3 w, vec2 q, vec2 at, float Z) {
    if (texel.cylinder) {
        vec3 from = vec3(q - vec2(dot(u, texel.a), dot(v, texel.a)), 0.0);
        vec3 axis = vec3(dot(u, texel.axis), dot(v, texel.axis), dot(w, texel.axis));
        // Squared distance of the ray's points (from, t) from the axis is a parabola in t.
        float A = max(1.0 - axis.z * axis.z, 1e-6);
        float along = dot(from.xy, axis.xy);
        float t0 = axis.z * along / A;
        vec3 foot = vec3(from.xy, t0) - axis * (along + axis.z * t0);
        float h = texel.radius * texel.radius - dot(foot, foot);
        return h > 0.0 ? dot(w, texel.a) + t0 + sqrt(h / A) : Z;
    }
    vec2 d = q - vec2(dot(u, texel.a), dot(v, texel.a));
    float h = texel.radius * texel.radius - dot(d, d);
    return h > 0.0 ? dot(w, texel.a) + sqrt(h) : Z;
}

void main() {
    uint entry = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    if (entry >= bake.texelCount) return;
    uint index = texels[bake.firstTexel + entry];
    Texel texel = texelAt(index);
    float pixels = bake.map.x, perRow = bake.map.y, scale = bake.map.z;
    float sum = 0.0;
    for (uint i = 0u; i < bake.directionCount; ++i) {
        uint row = 3u * (bake.firstDirection + i);
        vec3 w = rows[row + 2u].xyz;
        float cosine = dot(texel.normal, w);
        if (cosine <= 0.0) continue;
        vec3 u = rows[row].xyz, v = rows[row + 1u].xyz;
        vec2 at = vec2(dot(u, texel.position), dot(v, texel.position));
        // Continuous pixel coordinates whose integers are pixel centres; y points down.
        vec2 pixel = vec2(at.x, -at.y) * scale + 0.5 * pixels - 0.5;
        vec2 base = floor(pixel), part = pixel - base;
        vec2 tile = vec2(mod(float(i), perRow), floor(float(i) / perRow)) * pixels;
        float Z = dot(w, texel.position);
        float lit = 0.0;
        // The four maps' pixels around the point, each compared with what this surface would have written there:
        // no bias is needed against self-shadowing, and shadows' edges come out smooth.
        for (int corner = 0; corner < 4; ++corner) {
            vec2 offset = vec2(corner & 1, corner >> 1);
            vec2 place = clamp(base + offset, vec2(0.0), vec2(pixels - 1.0));
            float weight = (offset.x > 0.0 ? part.x : 1.0 - part.x) * (offset.y > 0.0 ? part.y : 1.0 - part.y);
            vec2 q = (place + 0.5 - 0.5 * pixels) / scale;
            float own = ownZ(texel, u, v, w, vec2(q.x, -q.y), at, Z);
            float d = (bake.depth.z - own - bake.depth.x) * bake.depth.y;
            float nearest = decodeDepth(texelFetch(depthMaps, ivec2(tile + place), 0));
            lit += d <= nearest + bake.map.w ? weight : 0.0;
        }
        sum += cosine * lit;
    }
    sums[index] += sum;
}
