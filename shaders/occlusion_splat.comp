#version 450
// Depth maps without a rasteriser: every primitive puts its depth into each pixel that it covers, by an atomic minimum.
// For devices where a small triangle costs more than the pixels in it. One row of workgroups a direction.
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"
#include "common/texel.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 2, std430) buffer Maps { uint maps[]; };  // depth 0..1 as bits, which keep its order

void put(ivec2 pixel, float height) {
    float d = max((bake.depth.z - height - bake.depth.x) * bake.depth.y, 0.0);
    uint bits = floatBitsToUint(d);
    uint at = uint(pixel.y) * bake.range.z + uint(pixel.x);
    if (bits < maps[at]) atomicMin(maps[at], bits);
}

void main() {
    uint entry = bake.range.x + gl_GlobalInvocationID.x;
    if (entry >= bake.range.y) return;
    int i = int(gl_WorkGroupID.y);
    Direction d = directions[i];
    float pixels = bake.map.x, scale = bake.map.y, middle = 0.5 * pixels;
    ivec2 tile = ivec2(i % kMapsAcross, i / kMapsAcross) * int(pixels);
#ifdef CYLINDER
    vec4 first = shapes[bake.patches.w + 2u * entry];
    float radius = first.w;
    vec3 a = placed(d, first.xyz), b = placed(d, shapes[bake.patches.w + 2u * entry + 1u].xyz);
    float span = length(b - a);
    vec3 axis = (b - a) / span;
    float A = 1.0 - axis.z * axis.z;
    vec2 reach = radius * sqrt(max(1.0 - axis.xy * axis.xy, vec2(0.0)));  // of a cap
    vec2 low = min(a.xy, b.xy) - reach, high = max(a.xy, b.xy) + reach;
#else
    vec4 sphere = shapes[entry];
    float radius = sphere.w;
    vec3 a = placed(d, sphere.xyz);
    vec2 low = a.xy - radius, high = a.xy + radius;
#endif
    // Pixels whose centres may lie inside; y points down.
    ivec2 from = max(ivec2(ceil(vec2(low.x, -high.y) * scale + middle - 0.5)), ivec2(0));
    ivec2 to = min(ivec2(floor(vec2(high.x, -low.y) * scale + middle - 0.5)), ivec2(int(pixels) - 1));
    for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) {
            vec2 q = (vec2(x, y) + 0.5 - middle) / scale;
            vec2 way = vec2(q.x, -q.y) - a.xy;
#ifdef CYLINDER
            float along = dot(way, axis.xy);
            float t0 = A > 1e-6 ? axis.z * along / A : 0.0;
            vec3 foot = vec3(way, t0) - axis * (along + axis.z * t0);
            float h = radius * radius - dot(foot, foot);
            float t = t0 + sqrt(max(h, 0.0) / max(A, 1e-6));
            float place = along + axis.z * t;
            bool side = h > 0.0 && A > 1e-6 && place >= 0.0 && place <= span;
            // The cap that faces the light: b's if the axis rises.
            float cap = ((axis.z > 0.0 ? span : 0.0) - along) / (abs(axis.z) > 1e-6 ? axis.z : 1e-6);
            vec3 onTop = vec3(way, cap) - axis * (along + axis.z * cap);
            bool onCap = abs(axis.z) > 1e-6 && dot(onTop, onTop) < radius * radius;
            if (side || onCap) put(tile + ivec2(x, y), a.z + (side ? t : cap));
#else
            float h = radius * radius - dot(way, way);
            if (h > 0.0) put(tile + ivec2(x, y), a.z + sqrt(h));
#endif
        }
}
