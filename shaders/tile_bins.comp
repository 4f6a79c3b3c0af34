#version 440
// Finds the bins that each primitive may touch. Run twice: first counts the entries of each bin, then writes them. Several
// invocations share the bins of a primitive, so that large ones do not take long.
//   CYLINDERS, TRIANGLES   the scene has some
#extension GL_GOOGLE_include_directive : require
#define TILES
#define COPY_OF_PIXEL
#define STREAMS 0
#define CALLS 2
#include "common/hit.glsl"
#include "common/streams.glsl"
#include "common/bounding_disc.glsl"
#include "common/calls.glsl"
#include "common/list_layout.glsl"

layout(local_size_x = 64) in;
layout(constant_id = kWritesId) const bool kWrites = false;
layout(push_constant) uniform Push { TileConstants push; };
layout(set = 0, binding = 3, std430) buffer Work { uint work[]; };

struct Reach {
    uint number, step;
    uvec2 first, end;  // bins
    bool small;
};

/// From the plane z = 0 to the image.
vec2 toPixel(vec2 q) { return view.axisPixel + turned(vec2(q.x, -q.y) / view.pixel); }

/// A box in the picture. @param near  Z @returns false: outside the picture
bool reaches(vec2 low, vec2 high, float near, inout Reach r) {
    const float perBin = 1.0 / float(8 * kTilesInBin);
    vec2 first = low * perBin, last = high * perBin, bins = vec2(view.across, down);
    if (!(all(greaterThanEqual(last, vec2(0.0))) && all(lessThan(first, bins)))) return false;
    r.first = uvec2(max(first, 0.0));
    r.end = uvec2(min(last + 1.0, bins));
    r.step = uint(clamp(encodedDepth(near) * float(kListSteps), 0.0, float(kListSteps - 1u)));
    return true;
}

bool sphereReach(uint index, inout Reach r) {
    vec4 shape = shapeAt(index);
    vec3 center = toView(shape.xyz);
    float Z = view.origin - center.z;
    if (kClip && (Z + shape.w < view.clipNear || Z - shape.w > view.clipFar)) return false;
    vec3 disc = boundingDisc(center, outlinedRadius(center.z, shape.w));
    vec2 at = toPixel(disc.xy);
    float reach = disc.z / view.pixel;
    r.small = reach < small;
    return reaches(at - reach, at + reach, Z - shape.w * 1.001, r);
}

#ifdef CYLINDERS
bool cylinderReach(uint index, inout Reach r) {
    uint at = 2u * index - view.spheres;
    vec4 shape = shapeAt(at);
    vec3 a = toView(shape.xyz), b = toView(shapeAt(at + 1u).xyz);
    float radius = abs(stickRadius(shape.w, a.z, b.z));
    vec3 from = boundingDisc(a, outlinedRadius(a.z, radius)), to = boundingDisc(b, outlinedRadius(b.z, radius));
    vec2 pa = toPixel(from.xy), pb = toPixel(to.xy);
    float ra = from.z / view.pixel, rb = to.z / view.pixel;
    r.small = min(ra, rb) < small;
    return reaches(min(pa - ra, pb - rb), max(pa + ra, pb + rb), view.origin - max(a.z, b.z) - radius * 1.001, r);
}
#endif

#ifdef TRIANGLES
bool triangleReach(uint index, inout Reach r) {
    Facet f = loadFacet(index);
    vec3 a = projectVertex(f.a, f.step), b = projectVertex(f.b, f.step), c = projectVertex(f.c, f.step);
    vec3 Z = kPerspective ? 1.0 / vec3(a.z, b.z, c.z) : vec3(a.z, b.z, c.z);
    float near = min(Z.x, min(Z.y, Z.z)) - 1e-3;
    if (kClip && (max(Z.x, max(Z.y, Z.z)) + 1e-3 < view.clipNear || near > view.clipFar)) return false;
    vec2 pa = toPixel(a.xy), pb = toPixel(b.xy), pc = toPixel(c.xy);
    float outside = (kContours ? contourReach() / view.pixel : 0.0) + 0.05;
    r.small = false;
    return reaches(min(pa, min(pb, pc)) - outside, max(pa, max(pb, pc)) + outside, near, r);
}
#endif

bool findReach(uint item, inout Reach r) {
    r.number = findNumber(item);
    uint index = place(r.number);
#ifdef TRIANGLES
    if (isTriangle(index)) return triangleReach(index, r);
#endif
#ifdef CYLINDERS
    if (index >= view.spheres) return cylinderReach(index, r);
#endif
    return sphereReach(index, r);
}

void add(Reach r, uvec2 at) {
    uint bin = at.y * view.across + at.x;
    if (kWrites) {
        uint bins = view.across * down, place = atomicAdd(work[bins + bin], 1u), entry = 2u * (bins + place);
        if (place >= kNoRoom) return;
        work[entry] = r.step;
        work[entry + 1u] = r.number;
    } else {
        atomicAdd(work[bin], 1u);
        if (r.small) atomicOr(work[bin], kSmallBit);
    }
}

void main() {
    view = push;
    uint at = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationIndex;
    Reach r = Reach(0u, 0u, uvec2(0u), uvec2(0u), false);
    if (at / share >= items || !findReach(at / share, r)) return;
    uvec2 size = r.end - r.first;
    for (uint k = at % share; k < size.x * size.y; k += share) add(r, r.first + uvec2(k % size.x, k / size.x));
}
