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

/// Height at which the texel's own surface meets a pixel centre; Z where it does not.
float ownZ(Texel texel, vec3 u, vec3 v, vec3 w, vec2 q, float Z) {
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
        float cosine = texel.whole ? 1.0 : dot(texel.normal, w);
        if (cosine <= 0.0) continue;
        vec3 position = texel.whole ? texel.a + texel.radius * w : texel.position;
        vec3 u = rows[row].xyz, v = rows[row + 1u].xyz;
        vec2 at = vec2(dot(u, position), dot(v, position));
        vec2 place = clamp(floor(vec2(at.x, -at.y) * scale + 0.5 * pixels), vec2(0.0), vec2(pixels - 1.0));
        vec2 tile = vec2(mod(float(i), perRow), floor(float(i) / perRow)) * pixels;
        // What this very surface would have written at the pixel's centre, so that it never shadows itself; or the
        // texel's own depth, if that is nearer: beside a contact the surface at the centre may lie inside a neighbour
        // that does not hide the texel. A pixel's width of slack allows for the neighbour's slope.
        vec2 q = (place + 0.5 - 0.5 * pixels) / scale;
        float Z = dot(w, position);
        float front = max(ownZ(texel, u, v, w, vec2(q.x, -q.y), Z), Z);
        float d = (bake.depth.z - front - bake.map.w - bake.depth.x) * bake.depth.y;
        if (d <= decodeDepth(texelFetch(depthMaps, ivec2(tile + place), 0))) sum += cosine;
    }
    sums[index] += sum;
}
