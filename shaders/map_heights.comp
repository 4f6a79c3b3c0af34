#version 440
// Depth maps of the occlusion bake by compute: an invocation per primitive and map raises the heights of the pixels that
// the primitive covers. Maps of a batch lie side by side, each with its own copies and rotation.
//   CYLINDERS, TRIANGLES   the scene has some
#extension GL_GOOGLE_include_directive : require
#define TILES
#define COPY_OF_PIXEL
#define STREAMS 0
#define CALLS 2
#include "common/hit.glsl"
#include "common/streams.glsl"
#include "common/calls.glsl"
#include "common/ordered.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push {  // engine/tiles/splat_maps.cpp
    float origin, pixel, middle;      // radius of the scene, Å; width of a pixel, Å; the view axis in a map, pixels
    uint primitives, spheres, cylinders;  // per copy
    uint mapPixels, apart, pitch;     // width of a map; from one map to the next; row of the batch
    uint across, copies;              // maps per row; copies per map
    uint first, end;                  // items
} push;
layout(set = 0, binding = 3, std430) buffer Heights { uint heights[]; };  // orderedBits(), Å

uint corner;  // of the map

void raise(uvec2 at, float height) {
    uint place = corner + at.y * push.pitch + at.x, word = orderedBits(height);
    if (heights[place] < word) atomicMax(heights[place], word);
}

/// Pixels of a map whose centres lie in a box on the plane z = 0. @returns first and end
uvec4 pixelsIn(vec2 low, vec2 high) {
    vec2 a = vec2(low.x, -high.y) / view.pixel + view.axisPixel, b = vec2(high.x, -low.y) / view.pixel + view.axisPixel;
    vec2 most = vec2(float(push.mapPixels));
    return uvec4(clamp(a - 0.5, vec2(0.0), most), clamp(b + 1.5, vec2(0.0), most));
}

void drawSphere(uint index) {
    vec4 shape = shapeAt(index);
    vec3 center = toView(shape.xyz);
    uvec4 box = pixelsIn(center.xy - shape.w, center.xy + shape.w);
    for (uint y = box.y; y < box.w; ++y)
        for (uint x = box.x; x < box.z; ++x) {
            vec2 away = planePoint(vec2(x, y) + 0.5) - center.xy;
            float h = shape.w * shape.w - away.x * away.x - away.y * away.y;
            if (kEllipsoids == 0) {
                if (h > 0.0) raise(uvec2(x, y), center.z + sqrt(h));
            } else {
                Hit hit = ballHitThrough(index, vec4(center, shape.w), away + center.xy);
                if (hit.inside) raise(uvec2(x, y), view.origin - hit.Z);
            }
        }
}

#ifdef CYLINDERS
void drawCylinder(uint index) {
    uint at = 2u * index - view.spheres;
    vec4 a = shapeAt(at);
    vec3 from = toView(a.xyz);
    vec4 to = endToView(shapeAt(at + 1u));
    float radius = stickRadius(a.w, from.z, to.z), r = abs(radius);
    Stick stick = makeStick(from, to, radius);
    uvec4 box = pixelsIn(min(from.xy, to.xy) - r, max(from.xy, to.xy) + r);
    for (uint y = box.y; y < box.w; ++y)
        for (uint x = box.x; x < box.z; ++x) {
            Hit hit = stickHitThrough(stick, planePoint(vec2(x, y) + 0.5));
            if (hit.inside) raise(uvec2(x, y), view.origin - hit.Z);
        }
}
#endif

#ifdef TRIANGLES
void drawTriangle(uint index) {
    Facet f = loadFacet(index);
    vec3 a = projectVertex(f.a, f.step), b = projectVertex(f.b, f.step), c = projectVertex(f.c, f.step);
    uvec4 box = pixelsIn(min(a.xy, min(b.xy, c.xy)), max(a.xy, max(b.xy, c.xy)));
    for (uint y = box.y; y < box.w; ++y)
        for (uint x = box.x; x < box.z; ++x) {
            Hit hit = triangleHitThrough(a, b, c, 0u, planePoint(vec2(x, y) + 0.5));
            if (hit.inside) raise(uvec2(x, y), view.origin - hit.Z);
        }
}
#endif

void main() {
    view.origin = push.origin;
    view.pixel = push.pixel;
    view.axisPixel = vec2(push.middle);
    view.primitives = push.primitives;
    view.spheres = push.spheres;
    view.cylinders = push.cylinders;
    view.depthStart = 0.0;
    view.perRange = 0.5 / push.origin;
    uint item = push.first + (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationIndex;
    if (item >= push.end) return;
    uint index = place(findNumber(item)), map = copyIndex / push.copies;
    corner = (map / push.across * push.pitch + map % push.across) * push.apart;
#ifdef TRIANGLES
    if (isTriangle(index)) {
        drawTriangle(index);
        return;
    }
#endif
#ifdef CYLINDERS
    if (index >= view.spheres) {
        drawCylinder(index);
        return;
    }
#endif
    drawSphere(index);
}
