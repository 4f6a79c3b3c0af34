#version 450
// Depth maps without a rasteriser: every primitive puts its depth into each pixel that it covers, by an atomic minimum.
// For devices where a small triangle costs more than the pixels in it. One row of workgroups a map.
#extension GL_GOOGLE_include_directive : require
#define SPLAT
#include "common/hit.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Shapes { vec4 shapes[]; };
layout(set = 0, binding = 2, std430) buffer Maps { uint maps[]; };  // depth 0..1 as bits, which keep its order

void put(ivec2 pixel, float Z) {
    uint bits = floatBitsToUint(max(encodedDepth(Z), 0.0));
    uint at = uint(pixel.y) * splat.pitch + uint(pixel.x);
    if (bits < maps[at]) atomicMin(maps[at], bits);
}

void main() {
    uint entry = splat.first + gl_GlobalInvocationID.x;
    if (entry >= splat.end) return;
    view = views[splat.view + gl_WorkGroupID.y];
#ifdef CYLINDER
    vec4 first = shapes[splat.spheres + 2u * entry];
    float radius = first.w;
    precise vec3 a = toView(first.xyz);
    precise vec3 b = toView(shapes[splat.spheres + 2u * entry + 1u].xyz);
    vec3 axis = normalize(b - a);
    vec2 reach = radius * sqrt(max(1.0 - axis.xy * axis.xy, vec2(0.0)));  // of a cap
    vec2 low = min(a.xy, b.xy) - reach, high = max(a.xy, b.xy) + reach;
#else
    vec4 shape = shapes[entry];
    float radius = shape.w;
    vec4 sphere = vec4(toView(shape.xyz), radius);
    vec2 low = sphere.xy - radius, high = sphere.xy + radius;
#endif
    // Pixels that may lie inside, in the image of the batch, whose rows run downwards.
    ivec2 corner = ivec2(view.axisPixel) - int(splat.pixels) / 2;
    ivec2 from = ivec2(floor(vec2(low.x, -high.y) / view.pixel + view.axisPixel - 0.5));
    ivec2 to = ivec2(ceil(vec2(high.x, -low.y) / view.pixel + view.axisPixel - 0.5));
    from = max(from, corner);
    to = min(to, corner + int(splat.pixels) - 1);
    for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) {
#ifdef CYLINDER
            Hit hit = cylinderHit(a, b, radius, vec2(x, y) + 0.5);
#else
            Hit hit = sphereHit(sphere, vec2(x, y) + 0.5);
#endif
            if (hit.inside) put(ivec2(x, y), hit.Z);
        }
}
