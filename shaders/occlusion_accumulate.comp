#version 450
// Ambient occlusion, one batch of directions: every texel of the list asks each depth map of the batch whether it is
// the front-most at its place, and adds up the cosine of those that say yes. One read and one write of its sum.
// CYLINDER: texels of cylinders. WHOLE: one value for a sphere, asked at its point that faces the light.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "common/layout.h"
#include "common/texel.glsl"
#include "common/encoding.glsl"

layout(local_size_x = 64) in;

layout(constant_id = kTapsId) const int kTaps = 1;        // 1 or 4: pixels asked for a texel
layout(constant_id = kSpreadId) const float kSpread = 0.0;  // of four taps, pixels

layout(set = 0, binding = 2, std430) readonly buffer Texels { uint texels[]; };
layout(set = 0, binding = 3, std430) buffer Sums { vec2 sums[]; };  // light that came, light that could have come
layout(set = 0, binding = 4) uniform sampler2D depthMaps;

/// Height of the texel's own surface above the place q of a depth map, view space; z where it does not reach there.
#ifdef CYLINDER
float ownHeight(vec3 center, vec3 axis, float radius, vec2 q, float z) {
    vec2 from = q - center.xy;
    // Squared distance of the ray's points (from, t) from the axis is a parabola in t.
    float A = max(1.0 - axis.z * axis.z, 1e-6);
    float along = dot(from, axis.xy);
    float t0 = axis.z * along / A;
    vec3 foot = vec3(from, t0) - axis * (along + axis.z * t0);
    float h = radius * radius - dot(foot, foot);
    return h > 0.0 ? center.z + t0 + sqrt(h / A) : z;
}
#else
float ownHeight(vec3 center, vec3 axis, float radius, vec2 q, float z) {
    vec2 from = q - center.xy;
    float h = radius * radius - dot(from, from);
    return h > 0.0 ? center.z + sqrt(h) : z;
}
#endif

/// Whether the depth map of direction i shows the texel, `aside` pixels from its place.
bool frontmost(int i, vec3 center, vec3 axis, float radius, vec3 at, vec2 aside) {
    float pixels = bake.mapPixels, scale = bake.pixelsPerAngstrom, middle = 0.5 * pixels;
    vec2 place = clamp(floor(vec2(at.x, -at.y) * scale + middle + aside), vec2(0.0), vec2(pixels - 1.0));
    // What this very surface would have written at the pixel's centre, so that it never shadows itself; or the texel's
    // own height, if that is nearer: beside a contact the surface at the centre may lie inside a neighbour that does
    // not hide the texel. A pixel's width of slack, more for a tap aside, allows for the neighbour's slope.
    vec2 q = (place + 0.5 - middle) / scale;
    float front = max(ownHeight(center, axis, radius, vec2(q.x, -q.y), at.z), at.z);
    float own = (bake.origin - front - bake.slack * (1.0 + length(aside)) - bake.depthStart) * bake.perRange;
    ivec2 tile = ivec2(i % kMapsAcross, i / kMapsAcross) * int(pixels);
    return own <= decodeDepth(texelFetch(depthMaps, tile + ivec2(place), 0));
}

void main() {
    uint listed = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    if (listed >= bake.entries) return;
    uint entry = bake.firstEntry + listed;
#ifdef CYLINDER
    Texel texel = cylinderTexel(texels[entry]);
#else
    Texel texel = sphereTexel(texels[entry]);
#endif
    precise vec2 sum = sums[entry];
    [[unroll]] for (int i = 0; i < kBatch; ++i) {
        Direction d = directions[i];
        vec3 center = placed(d, texel.a);
#ifdef WHOLE
        // A sphere that lies in a surface is seen from half of all directions: that half is what shows of it.
        float cosine = 0.5 * dot(d.w.xyz, d.w.xyz), counted = 2.0 * cosine;
        vec3 at = vec3(center.xy, center.z + texel.radius);
#else
        vec3 normal = turned(d, texel.normal);
        float cosine = max(normal.z, 0.0), counted = cosine;
        vec3 at = center + texel.radius * normal;
#endif
        vec3 axis = turned(d, texel.axis);
        float seen = 0.0;
        [[unroll]] for (int tap = 0; tap < kTaps; ++tap) {
            // Four taps stand in a square, askew, so that each has its own column and row.
            vec2 aside = tap % 2 == 0 ? vec2(0.75, 0.25) : vec2(-0.25, 0.75);
            aside *= kTaps == 1 ? 0.0 : tap < 2 ? kSpread : -kSpread;
            if (frontmost(i, center, axis, texel.radius, at, aside)) seen += 1.0 / float(kTaps);
        }
        sum += vec2(seen * counted, cosine);
    }
    sums[entry] = sum;
}
